//! What is computed once, when it is first asked for.

use std::cell::RefCell;

/// Values by key: so few that they are looked for one by one, which spares users the compilation of a map for each kind.
#[derive(Clone, Debug)]
pub(super) struct Memo<K, V> {
    known: RefCell<Vec<(K, V)>>,
}

impl<K, V> Default for Memo<K, V> {
    fn default() -> Self {
        Self { known: RefCell::default() }
    }
}

impl<K: PartialEq, V: Clone> Memo<K, V> {
    pub(super) fn get(&self, key: K, compute: impl FnOnce() -> V) -> V {
        let known = self.known.borrow().iter().find(|(known, _)| *known == key).map(|(_, value)| value.clone());
        known.unwrap_or_else(|| {
            let value = compute();
            self.known.borrow_mut().push((key, value.clone()));
            value
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_computed_once() {
        let memo = Memo::default();
        let doubled = |key: u32| memo.get(key, || 2 * key);
        assert_eq!([1, 2, 1].map(doubled), [2, 4, 2]);
        assert_eq!(memo.get(2, || panic!("again")), 4);
        assert_eq!(memo.clone().get(1, || panic!("again")), 2);
    }
}
