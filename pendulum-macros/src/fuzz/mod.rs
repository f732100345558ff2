//! Fuzzing, in process: whatever stands in an invocation, its expansion never panics, takes less than a second, and is
//! either code that keeps the promise of its own plan or errors that say where.
//!
//! The tests run a few thousand inputs. For a long run, in which each thread has its own seeds,
//!
//! ```text
//! PENDULA_FUZZ_SECONDS=1200 cargo test --release -p pendulum-macros fuzz::long -- --ignored --nocapture
//! ```
//!
//! `PENDULA_FUZZ_SEED` starts another sequence, `PENDULA_FUZZ_THREADS` (2) sets the number of threads.

mod findings;
pub(crate) mod grammar;
mod mutation;
mod promise;
mod verdict;

use crate::testing::Random;
use std::sync::Mutex;
use std::time::{Duration, Instant};
use verdict::{Verdict, judge};

type Generator = fn(&mut Random) -> String;

const GENERATORS: [(&str, Generator); 4] = [
    ("invocations", |random| grammar::invocation(random).text()),
    ("near misses", mutation::near_miss),
    ("token soup", mutation::soup),
    ("far units", grammar::far_units),
];

/// What a run found.
#[derive(Default)]
struct Tally {
    planned: usize,
    refused: usize,
    unlexable: usize,
    slowest: (Duration, String),
    failures: Vec<String>,
}

impl Tally {
    fn judge(&mut self, text: &str) {
        match judge(text) {
            Ok((verdict, time)) => {
                let count = match verdict {
                    Verdict::Planned => &mut self.planned,
                    Verdict::Refused => &mut self.refused,
                    Verdict::Unlexable => &mut self.unlexable,
                };
                *count += 1;
                if time > self.slowest.0 {
                    self.slowest = (time, text.to_owned());
                }
            }
            Err(what) => self.failures.push(format!("{what}\n    {text}")),
        }
        // The compiler's spans of all text ever parsed on this thread would add up.
        proc_macro2::extra::invalidate_current_thread_spans();
    }

    fn report(&self, name: &str) -> String {
        let Self { planned, refused, unlexable, slowest, failures } = self;
        format!(
            "{name}: {planned} planned, {refused} refused, {unlexable} not tokens, {} failures; slowest {:?}\n    {}",
            failures.len(),
            slowest.0,
            slowest.1
        )
    }
}

fn quick(generator: usize, count: u64) {
    let (name, generate) = GENERATORS[generator];
    let mut tally = Tally::default();
    for seed in 0..count {
        tally.judge(&generate(&mut Random::new(seed)));
    }
    println!("{}", tally.report(name));
    assert!(tally.failures.is_empty(), "{}\n{}", tally.report(name), tally.failures.join("\n"));
}

#[test]
fn invocations() {
    quick(0, 60);
}

#[test]
fn near_misses() {
    quick(1, 300);
}

#[test]
fn token_soup() {
    quick(2, 1000);
}

#[test]
fn far_units() {
    quick(3, 100);
}

/// A number from the environment.
pub(crate) fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(default)
}

/// Longer than the judgement of any invocation takes, on a loaded machine.
const HANG: Duration = Duration::from_secs(20);

/// Much more than the judgements of all threads take.
const MEMORY: u64 = 2 << 30;

/// What this process holds, on Linux.
fn resident_memory() -> Option<u64> {
    let pages: u64 = std::fs::read_to_string("/proc/self/statm").ok()?.split(' ').nth(1)?.parse().ok()?;
    Some(pages * 4096)
}

/// Of seven inputs three are invocations, two near misses.
#[test]
#[ignore = "runs for PENDULA_FUZZ_SECONDS"]
fn long() {
    let end = Instant::now() + Duration::from_secs(setting("PENDULA_FUZZ_SECONDS", 60));
    let (first, threads) = (setting("PENDULA_FUZZ_SEED", 1) << 40, setting("PENDULA_FUZZ_THREADS", 2));
    let run = move |thread: u64, current: &Mutex<(Instant, String)>| {
        let mut tallies = GENERATORS.map(|_| Tally::default());
        for index in 0.. {
            let mut random = Random::new(first + (thread << 36) + index);
            let generator = random.choose(&[0, 0, 0, 1, 1, 2, 3]);
            let text = GENERATORS[generator].1(&mut random);
            *current.lock().unwrap() = (Instant::now(), text.clone());
            let known = tallies[generator].failures.len();
            tallies[generator].judge(&text);
            if let Some(failure) = tallies[generator].failures.get(known) {
                println!("{failure}");
            }
            if Instant::now() > end {
                break;
            }
        }
        tallies
    };
    let mut failures = 0;
    let start = || Mutex::new((Instant::now(), String::new()));
    let currents: Vec<_> = (0..threads).map(|_| start()).collect();
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..).zip(&currents).map(|(i, current)| scope.spawn(move || run(i, current))).collect();
        while !threads.iter().all(std::thread::ScopedJoinHandle::is_finished) {
            std::thread::sleep(Duration::from_millis(100));
            let greedy = resident_memory().is_some_and(|bytes| bytes > MEMORY);
            for (thread, current) in threads.iter().zip(&currents) {
                let (since, text) = &*current.lock().unwrap();
                if !thread.is_finished() && (since.elapsed() > HANG || greedy) {
                    println!("{}\n    {text}", if greedy { "takes all memory?" } else { "hangs?" });
                    std::process::exit(1);
                }
            }
        }
        for thread in threads {
            for ((name, _), tally) in GENERATORS.iter().zip(thread.join().expect("a failure is caught and counted")) {
                println!("{}", tally.report(name));
                failures += tally.failures.len();
            }
        }
    });
    assert_eq!(failures, 0);
}
