//! With which probability the rules of [`super::selection`] select each step: what a draw would give on average, without drawing.
//!
//! Sums are taken in f64; the rules themselves sum in f32, so that frequencies agree with these numbers to about 1e-6.

/// w_d / Σ w; all 0 where no step is left.
pub fn random_proportional(weights: &[f32]) -> Vec<f64> {
    let total: f64 = weights.iter().map(|&w| f64::from(w)).sum();
    weights.iter().map(|&w| if total > 0.0 { f64::from(w) / total } else { 0.0 }).collect()
}

/// q0 for the first of the largest weight, and of the rest, 1 − q0, each step its share by the random proportional rule.
pub fn pseudo_random_proportional(weights: &[f32], q0: f64) -> Vec<f64> {
    let mut odds: Vec<f64> = random_proportional(weights).iter().map(|p| (1.0 - q0) * p).collect();
    let largest = weights.iter().fold(0.0f32, |m, &w| if w > m { w } else { m });
    let best = weights.iter().position(|&w| w == largest && w > 0.0);
    best.into_iter().for_each(|d| odds[d] += q0);
    odds
}

/// Random proportional among the steps with w_d / Σ w ≤ λ; if there is none, uniform among the feasible ones.
pub fn threshold(weights: &[f32], lambda: f64) -> Vec<f64> {
    let total: f64 = weights.iter().map(|&w| f64::from(w)).sum();
    let candidates: Vec<f32> = weights.iter().map(|&w| if f64::from(w) <= lambda * total { w } else { 0.0 }).collect();
    if candidates.iter().any(|&w| w > 0.0) { random_proportional(&candidates) } else { uniform(weights, |w| w > 0.0) }
}

/// Uniform among the steps of the largest weight.
pub fn maximal(weights: &[f32]) -> Vec<f64> {
    let largest = weights.iter().fold(0.0f32, |m, &w| if w > m { w } else { m });
    uniform(weights, |w| w > 0.0 && w >= largest)
}

/// The same probability for each step whose weight is `among` those to choose from.
fn uniform(weights: &[f32], among: impl Fn(f32) -> bool) -> Vec<f64> {
    let ones: Vec<f32> = weights.iter().map(|&w| f32::from(u8::from(among(w)))).collect();
    random_proportional(&ones)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::aco::selection;
    use crate::aco::trails::Row;
    use crate::map::{DIRECTIONS, Direction};
    use crate::rng::{Stream, Streams};

    const DRAWS: u32 = 60_000;

    /// Frequencies of a rule lie within 4 standard deviations of the odds, where these are 0 or 1 exactly there.
    fn agree(weights: &Row, odds: &[f64], rule: impl Fn(&Row, &mut Stream) -> Option<Direction>) {
        let mut stream = Streams::new(11, "odds", 0).ant(0, 0);
        let mut counts = [0u32; DIRECTIONS];
        (0..DRAWS).filter_map(|_| rule(weights, &mut stream)).for_each(|d| counts[d as usize] += 1);
        for d in 0..DIRECTIONS {
            let expected = odds[d] * f64::from(DRAWS);
            let deviation = (expected * (1.0 - odds[d])).max(0.0).sqrt();
            assert!(
                (f64::from(counts[d]) - expected).abs() <= 4.0 * deviation + 1e-6,
                "direction {d}: {} of {expected}",
                counts[d]
            );
        }
        let sum: f64 = odds.iter().sum();
        let expected = if weights.iter().any(|&w| w > 0.0) { 1.0 } else { 0.0 };
        assert!((sum - expected).abs() < 1e-12, "{sum}");
    }

    #[test]
    fn odds_are_the_frequencies_of_the_rules() {
        let rows: [Row; 4] = [
            [0.0, 1.0, 0.0, 2.0, 0.0, 2.0, 0.5, 0.0],
            [1.0; DIRECTIONS],
            [0.0, 0.0, 0.0, 1.0, 0.0, 1e-30, 0.0, 0.0],
            [0.0; DIRECTIONS],
        ];
        for weights in &rows {
            agree(weights, &random_proportional(weights), selection::random_proportional);
            agree(weights, &maximal(weights), selection::maximal);
            for q0 in [0.25, 0.7, 1.0] {
                agree(weights, &pseudo_random_proportional(weights, q0), |w, s| selection::pseudo_random_proportional(w, q0, s));
            }
            for lambda in [0.0, 0.2, 0.4, 1.0] {
                agree(weights, &threshold(weights, lambda), |w, s| selection::threshold(w, lambda, s));
            }
        }
    }

    #[test]
    fn odds_by_hand() {
        let weights: Row = [0.0, 1.0, 0.0, 2.0, 0.0, 1.0, 0.0, 0.0];
        assert_eq!(random_proportional(&weights), [0.0, 0.25, 0.0, 0.5, 0.0, 0.25, 0.0, 0.0]);
        assert_eq!(pseudo_random_proportional(&weights, 0.5), [0.0, 0.125, 0.0, 0.75, 0.0, 0.125, 0.0, 0.0]);
        // 2 of 4 exceeds λ = 0.3: the others share; nothing is below λ = 0.1: all three share alike.
        assert_eq!(threshold(&weights, 0.3), [0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0]);
        let third = 1.0 / 3.0;
        assert_eq!(threshold(&weights, 0.1), [0.0, third, 0.0, third, 0.0, third, 0.0, 0.0]);
        assert_eq!(maximal(&weights), [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
    }
}
