//! A run that shares its work among threads, shows how far it is, and can be stopped.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread;

use indicatif::{ProgressBar, ProgressStyle};

/// What threads find is put together by this.
pub trait Merge: Default + Send {
    /// Takes in what another thread found.
    fn merge(&mut self, other: Self);
}

/// Threads, progress and a request to stop.
#[derive(Clone, Debug)]
pub struct Session {
    threads: usize,
    visible: bool,
    stop: Arc<AtomicBool>,
}

impl Session {
    /// For tests: as many threads as the machine has, no progress shown.
    pub fn quiet() -> Self {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        Self { threads, visible: false, stop: Arc::default() }
    }

    /// Shows its progress, and stops at Ctrl-C: pieces of work that have begun are finished, and what was found in them
    /// is reported. A second Ctrl-C ends the program.
    ///
    /// # Errors
    /// If the signal can't be handled.
    pub fn interactive(threads: usize) -> Result<Self, ctrlc::Error> {
        let session = Self { threads, visible: true, stop: Arc::default() };
        let stop = Arc::clone(&session.stop);
        ctrlc::set_handler(move || {
            if stop.swap(true, Ordering::Relaxed) {
                std::process::exit(130);
            }
            eprintln!("\nstopping after the work in hand");
        })?;
        Ok(session)
    }

    /// Whether a stop was asked for.
    pub fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Does `pieces` pieces of work, each by its number, in any order, on all threads, and puts together what was found.
    ///
    /// # Panics
    /// If `work` does.
    pub fn share<T: Merge>(&self, title: &str, pieces: u64, work: impl Fn(u64, &mut T) + Sync) -> T {
        let bar = self.bar(title, pieces);
        let next = AtomicU64::new(0);
        let labour = || {
            let mut mine = T::default();
            while !self.stopped() {
                let piece = next.fetch_add(1, Ordering::Relaxed);
                if piece >= pieces {
                    break;
                }
                work(piece, &mut mine);
                bar.inc(1);
            }
            mine
        };
        let found = thread::scope(|scope| {
            let workers: Vec<_> = (0..self.threads.max(1)).map(|_| scope.spawn(labour)).collect();
            let mut all = T::default();
            for worker in workers {
                all.merge(worker.join().expect("the work doesn't panic"));
            }
            all
        });
        bar.finish_and_clear();
        found
    }

    fn bar(&self, title: &str, pieces: u64) -> ProgressBar {
        if !self.visible {
            return ProgressBar::hidden();
        }
        let style = ProgressStyle::with_template("{msg} {wide_bar} {percent} % {eta}");
        let bar = ProgressBar::new(pieces).with_message(title.to_owned());
        bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
    }
}

#[cfg(test)]
mod tests {
    use super::{Merge, Session};
    use std::sync::atomic::{AtomicU64, Ordering};

    #[derive(Default)]
    struct Sum(u64);

    impl Merge for Sum {
        fn merge(&mut self, other: Self) {
            self.0 += other.0;
        }
    }

    #[test]
    fn every_piece_is_done_once() {
        let done = AtomicU64::new(0);
        let sum = Session::quiet().share("", 1000, |piece, sum: &mut Sum| {
            sum.0 += piece;
            done.fetch_add(1, Ordering::Relaxed);
        });
        assert_eq!((done.into_inner(), sum.0), (1000, 499_500));
    }

    #[test]
    fn what_was_done_before_a_stop_is_kept() {
        let session = Session::quiet();
        let done = AtomicU64::new(0);
        let sum = session.share("", u64::MAX, |_, sum: &mut Sum| {
            sum.0 += 1;
            done.fetch_add(1, Ordering::Relaxed);
            session.stop.store(true, Ordering::Relaxed);
        });
        assert!(sum.0 >= 1);
        assert_eq!(sum.0, done.into_inner());
    }
}
