//! Random streams: counter-based, so that an ant's numbers depend on (seed, planner, run, iteration, ant) and on nothing else.
//!
//! Adding a planner, reordering ants or stepping differently changes nobody's numbers. The generator is Xoshiro128++
//! (Blackman and Vigna 2021), which four ants can draw from in SIMD lanes with the very same numbers.

use rand::SeedableRng;
use rand_xoshiro::Xoshiro128PlusPlus;

/// The generator of every stream.
pub type Stream = Xoshiro128PlusPlus;

/// Where streams come from: one per planner run.
#[derive(Debug, Clone, Copy)]
pub struct Streams {
    key: u64,
}

impl Streams {
    /// The streams of one run of one planner.
    pub fn new(seed: u64, planner: &str, run: u32) -> Self {
        let id = planner.bytes().fold(0xcbf2_9ce4_8422_2325, |h: u64, b| (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3));
        Self { key: mix(mix(mix(0, seed), id), u64::from(run)) }
    }

    /// The stream of one ant in one iteration.
    ///
    /// ```
    /// use formicarium::rng::Streams;
    /// use rand::Rng;
    ///
    /// let streams = Streams::new(1, "ant-system", 0);
    /// let draw = |iteration, ant| streams.ant(iteration, ant).next_u32();
    /// assert_eq!(draw(3, 5), draw(3, 5));
    /// assert_ne!(draw(3, 5), draw(3, 6));
    /// ```
    pub fn ant(self, iteration: u32, ant: u32) -> Stream {
        let k = mix(self.key, (u64::from(iteration) << 32) | u64::from(ant));
        let mut bytes = [0u8; 16];
        bytes[..8].copy_from_slice(&mix(k, 1).to_le_bytes());
        bytes[8..].copy_from_slice(&mix(k, 2).to_le_bytes());
        Stream::from_seed(bytes)
    }

    /// The stream of what no single ant does in an iteration, e.g. a mutation of trails; no ant has that number.
    pub fn daemon(self, iteration: u32) -> Stream {
        self.ant(iteration, u32::MAX)
    }
}

/// SplitMix64's finalizer over a running state: a bijection in each argument.
fn mix(state: u64, value: u64) -> u64 {
    let mut z = state.wrapping_add(value.wrapping_mul(0x9e37_79b9_7f4a_7c15)).wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A uniform number in [0, 1) with 24 bits, from 32 random ones.
#[inline(always)]
pub fn unit_f32(bits: u32) -> f32 {
    (bits >> 8) as f32 * (1.0 / 16_777_216.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::Rng;

    #[test]
    fn streams_differ_in_every_coordinate_and_repeat() {
        let draw = |s: Streams, i, a| s.ant(i, a).next_u64();
        let base = Streams::new(1, "ant-system", 0);
        let all = [
            draw(base, 0, 0),
            draw(base, 1, 0),
            draw(base, 0, 1),
            base.daemon(0).next_u64(),
            draw(Streams::new(2, "ant-system", 0), 0, 0),
            draw(Streams::new(1, "ship", 0), 0, 0),
            draw(Streams::new(1, "ant-system", 1), 0, 0),
        ];
        for (i, a) in all.iter().enumerate() {
            assert!(all[..i].iter().all(|b| a != b));
        }
        assert_eq!(all[0], draw(base, 0, 0));
    }

    #[test]
    fn unit_stays_below_one() {
        assert!(unit_f32(u32::MAX) < 1.0);
        assert_eq!(unit_f32(0), 0.0);
    }
}
