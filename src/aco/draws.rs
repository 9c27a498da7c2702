//! Four ants' random streams side by side, with the same numbers as each of them alone (xoshiro128++, Blackman and Vigna 2021).

use rand::SeedableRng;
use wide::{bytemuck::cast, f32x4, i32x4, u32x4};

use crate::rng::Stream;

/// Four streams, word by word.
pub(super) struct Draws([u32x4; 4]);

impl Draws {
    /// These streams.
    #[inline(never)]
    pub fn of(streams: [&Stream; 4]) -> Self {
        let words = |stream: &Stream| {
            let state = stream.state();
            let (words, _) = state.as_chunks::<4>();
            u32x4::new(std::array::from_fn(|k| u32::from_le_bytes(words[k])))
        };
        Self(u32x4::transpose(streams.map(words)))
    }

    /// The next number of each stream, uniform in [0, 1) as by [`crate::rng::unit_f32`]; only those of the mask go on. `all`: that these are
    /// all.
    #[inline(always)]
    pub fn next(&mut self, which: u32x4, all: bool) -> f32x4 {
        let [a, b, c, d] = self.0;
        let drawn = rotated::<7>(a + d) + a;
        let (c2, d2) = (c ^ a, d ^ b);
        let next = [a ^ d2, b ^ c2, c2 ^ (b << 9u32), rotated::<11>(d2)];
        if all {
            self.0 = next;
        } else {
            for (word, next) in self.0.iter_mut().zip(next) {
                *word = which.bitselect(next, *word);
            }
        }
        f32x4::from_i32x4(cast::<u32x4, i32x4>(drawn >> 8u32)) * f32x4::splat(1.0 / 16_777_216.0)
    }

    /// The streams as they are now.
    #[inline(never)]
    pub fn streams(self) -> [Stream; 4] {
        u32x4::transpose(self.0).map(|words| {
            let mut state = [0; 16];
            let (bytes, _) = state.as_chunks_mut::<4>();
            bytes.iter_mut().zip(words.to_array()).for_each(|(bytes, word)| *bytes = word.to_le_bytes());
            Stream::from_seed(state)
        })
    }
}

#[inline(always)]
fn rotated<const BY: u32>(words: u32x4) -> u32x4 {
    words << BY | words >> (32 - BY)
}

#[cfg(test)]
mod tests {
    use rand::Rng;

    use super::*;
    use crate::rng::{Streams, unit_f32};

    #[test]
    fn the_same_numbers_as_each_stream_alone() {
        let mut alone: [Stream; 4] = std::array::from_fn(|k| Streams::new(3, "test", 0).ant(1, k as u32));
        let mut draws = Draws::of(alone.each_ref());
        for round in 0..200u32 {
            let going: [bool; 4] = std::array::from_fn(|k| round % 3 == 0 || round >> k & 1 == 1);
            let mask = u32x4::new(going.map(|goes| if goes { u32::MAX } else { 0 }));
            let drawn = draws.next(mask, going == [true; 4]).to_array();
            for k in (0..4).filter(|&k| going[k]) {
                assert_eq!(drawn[k], unit_f32(alone[k].next_u32()));
            }
        }
        assert_eq!(draws.streams(), alone);
    }
}
