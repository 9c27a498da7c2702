//! What a search has seen and not expanded: buckets of f, each worked off last in, first out.

use std::collections::VecDeque;

/// What waits, by bucket. Steps are short, so few buckets are in use at a time: those that are worked off serve again further up.
#[derive(Debug, Clone)]
pub(super) struct Frontier<T> {
    /// From the bucket at work upwards.
    buckets: VecDeque<Vec<T>>,
    /// The number of the bucket at work, and the largest that was ever filed under.
    at_work: usize,
    last: usize,
}

impl<T> Default for Frontier<T> {
    fn default() -> Self {
        Self { buckets: VecDeque::new(), at_work: 0, last: 0 }
    }
}

impl<T> Frontier<T> {
    /// The bucket at work, counted from 0.
    pub(super) fn at_work(&self) -> usize {
        self.at_work
    }

    /// Adds to a bucket; one that is worked off already stands for the bucket at work.
    #[inline(always)]
    pub(super) fn file(&mut self, bucket: usize, waiting: T) {
        let ahead = bucket.saturating_sub(self.at_work);
        self.last = self.last.max(bucket);
        match self.buckets.get_mut(ahead) {
            Some(bucket) => bucket.push(waiting),
            None => self.file_first(ahead, waiting),
        }
    }

    /// Adds to a bucket that there is none of yet.
    #[cold]
    fn file_first(&mut self, ahead: usize, waiting: T) {
        while self.buckets.len() < ahead {
            self.buckets.push_back(Vec::new());
        }
        self.buckets.push_back(vec![waiting]);
    }

    /// What came last into the bucket at work.
    #[inline(always)]
    pub(super) fn pop(&mut self) -> Option<T> {
        self.buckets.front_mut()?.pop()
    }

    /// Whether a later bucket was ever filed under.
    pub(super) fn has_more(&self) -> bool {
        self.at_work < self.last
    }

    /// Goes on to the next bucket, once this one is empty.
    pub(super) fn next(&mut self) {
        debug_assert!(self.buckets.front().is_none_or(Vec::is_empty));
        self.at_work += 1;
        if let Some(worked_off) = self.buckets.pop_front() {
            self.buckets.push_back(worked_off);
        }
    }

    /// All that the bucket at work holds.
    pub(super) fn take(&mut self) -> impl Iterator<Item = T> {
        self.buckets.front_mut().into_iter().flat_map(|bucket| bucket.drain(..))
    }

    /// All that waits, bucket by bucket; nothing is left.
    pub(super) fn take_all(&mut self) -> impl Iterator<Item = T> + use<T> {
        std::mem::take(self).buckets.into_iter().flatten()
    }

    /// All that waits, in no order.
    #[cfg(feature = "whole")]
    pub(super) fn waiting(&self) -> impl Iterator<Item = &T> {
        self.buckets.iter().flatten()
    }

    /// What it holds, in bytes.
    pub(super) fn bytes(&self) -> usize {
        let waiting: usize = self.buckets.iter().map(Vec::capacity).sum();
        waiting * size_of::<T>() + self.buckets.capacity() * size_of::<Vec<T>>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(frontier: &mut Frontier<u32>) -> Vec<u32> {
        std::iter::from_fn(|| frontier.pop()).collect()
    }

    #[test]
    fn buckets_come_in_order_and_give_back_what_came_last() {
        let mut frontier = Frontier::default();
        assert_eq!((frontier.pop(), frontier.has_more()), (None, false));
        for (bucket, cell) in [(0, 1), (3, 2), (0, 3), (3, 4), (1, 5)] {
            frontier.file(bucket, cell);
        }
        assert_eq!(cells(&mut frontier), [3, 1]);
        frontier.next();
        frontier.file(0, 6);
        assert_eq!((cells(&mut frontier), frontier.at_work()), (vec![6, 5], 1));
        frontier.next();
        assert_eq!((cells(&mut frontier), frontier.has_more()), (vec![], true));
        frontier.next();
        frontier.file(9, 7);
        assert_eq!(cells(&mut frontier), [4, 2]);
        for bucket in 4..=9 {
            assert!(frontier.has_more(), "{bucket} is still to come");
            frontier.next();
        }
        assert_eq!((frontier.take().count(), frontier.has_more()), (1, false));
        let mut work_off = |buckets: std::ops::Range<usize>| {
            for bucket in buckets {
                frontier.file(bucket, 8);
                frontier.next();
                assert_eq!(cells(&mut frontier), [8]);
            }
            frontier.bytes()
        };
        let held = work_off(10..30);
        assert_eq!(work_off(30..1000), held, "buckets that are worked off serve again");
    }
}
