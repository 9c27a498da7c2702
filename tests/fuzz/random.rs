//! Random choices for inputs: everything about an input follows from the seed and its number.

use formicarium::rng::Streams;
use rand::Rng;
use rand_xoshiro::Xoshiro128PlusPlus;

pub struct Random(Xoshiro128PlusPlus);

impl Random {
    /// The choices for one input.
    pub fn of(seed: u64, number: u64) -> Self {
        Self(Streams::new(seed, "fuzz", (number >> 32) as u32).ant(number as u32, 0))
    }

    /// From 0 to `end` − 1; 0 where there is nothing to choose from.
    pub fn below(&mut self, end: usize) -> usize {
        if end == 0 { 0 } else { (self.0.next_u64() % end as u64) as usize }
    }

    /// Both included.
    pub fn between(&mut self, low: u32, high: u32) -> u32 {
        low + self.below((high - low + 1) as usize) as u32
    }

    pub fn one_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }

    pub fn of_list<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len())]
    }

    /// From 0 to 1.
    pub fn unit(&mut self) -> f64 {
        self.0.next_u32() as f64 / f64::from(u32::MAX)
    }

    pub fn byte(&mut self) -> u8 {
        self.0.next_u32() as u8
    }

    pub fn word(&mut self) -> u32 {
        self.0.next_u32()
    }

    /// A piece of a list: two places in order, hardly ever far apart.
    pub fn piece(&mut self, len: usize) -> std::ops::Range<usize> {
        let from = self.below(len + 1);
        let most = if self.one_in(4) { len } else { len.min(16) };
        from..(from + self.below(most + 1)).min(len)
    }
}
