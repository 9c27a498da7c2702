//! Eq. 2–9 of Zhou, Mu, Zhang 2019, as functions: explosions, mutations, survivors (`fireworks.rs` says whose choice is what).

use crate::planner::Reading;

use super::fireworks::FireworkRows;
use super::population::{Population, distance};

/// Eq. 2 and 3: what falls to one firework of `amount`, given its distance to the extreme length and the sum of all these distances.
///
/// S_i = m·(Y_max − f_i + ε) / (Σ(Y_max − f) + ε) and A_i = Â·(f_i − Y_min + ε) / (Σ(f − Y_min) + ε).
pub fn allotment(amount: f64, excess: f64, sum: f64) -> f64 {
    amount * (excess + f64::EPSILON) / (sum + f64::EPSILON)
}

/// The bounds of Eq. 2: round(a·m) below a·m, round(b·m) above b·m, round(S_i) between.
pub fn rounded_sparks(share: f64, rows: &FireworkRows) -> u32 {
    let (low, high) = (rows.fewest * rows.sparks, rows.most * rows.sparks);
    let bounded = if share < low { low } else { share.min(high) };
    libm::round(bounded) as u32
}

/// Eq. 2 and 3: sparks and radius of each firework, by the lengths of their paths.
pub fn explosions(rows: &FireworkRows, radius: f64, lengths: &[f64]) -> Vec<(u32, f64)> {
    let longest = lengths.iter().fold(f64::NEG_INFINITY, |m, &f| m.max(f));
    let shortest = lengths.iter().fold(f64::INFINITY, |m, &f| m.min(f));
    let below_longest: f64 = lengths.iter().map(|f| longest - f).sum();
    let above_shortest: f64 = lengths.iter().map(|f| f - shortest).sum();
    let explosion = |&f: &f64| {
        let sparks = allotment(rows.sparks, longest - f, below_longest);
        (rounded_sparks(sparks, rows), allotment(radius, f - shortest, above_shortest))
    };
    lengths.iter().map(explosion).collect()
}

/// Eq. 4: how far a spark of radius A_i flies, for a uniform draw from 0 to 1.
pub fn displacement(reading: Reading, radius: f64, draw: f64) -> f64 {
    match reading {
        Reading::Printed => radius * draw,
        Reading::Repaired => radius * (2.0 * draw - 1.0),
    }
}

/// Eq. 5: g with mean 1 and variance 1, for two uniform draws, the first above 0 (Box and Muller 1958).
pub fn gaussian(first: f64, second: f64) -> f64 {
    1.0 + libm::sqrt(-2.0 * libm::log(first)) * libm::cos(std::f64::consts::TAU * second)
}

/// Eq. 5 with the weight of Eq. 9: the factor on x. Without it, w = 1, the factor is g.
pub fn mutation_factor(g: f64, weight: f64) -> f64 {
    1.0 + weight * (g - 1.0)
}

/// Eq. 6: x_min + |x| % (x_max − x_min) where x is out of range.
pub fn confined(x: f64, min: f64, max: f64) -> f64 {
    if (min..=max).contains(&x) { x } else { min + x.abs() % (max - min) }
}

/// Eq. 7: R(x_i) = Σ_j ‖x_i − x_j‖ of every position.
pub fn crowding(population: &Population) -> Vec<f64> {
    let mut sums = vec![0.0; population.len()];
    for i in 0..population.len() {
        for j in 0..i {
            let d = distance(population.position(i), population.position(j));
            sums[i] += d;
            sums[j] += d;
        }
    }
    sums
}

/// Eq. 8: the index that a uniform draw from 0 to 1 meets when each has probability R / ΣR; uniform where all R are 0.
pub fn roulette(weights: &[f64], draw: f64) -> usize {
    let sum: f64 = weights.iter().sum();
    if sum <= 0.0 {
        return ((draw * weights.len() as f64) as usize).min(weights.len().saturating_sub(1));
    }
    let mut left = draw * sum;
    let met = weights.iter().position(|w| {
        left -= w;
        left < 0.0
    });
    met.unwrap_or(weights.len() - 1)
}

/// Eq. 9, first part: Â(G) = Â·c^(G / G_max).
pub fn cooled_radius(radius: f64, end: f64, g: u32, g_max: u32) -> f64 {
    radius * libm::pow(end, f64::from(g) / f64::from(g_max))
}

/// Eq. 9, second part: w falls linearly from `start` to `end`.
pub fn inertia(start: f64, end: f64, g: u32, g_max: u32) -> f64 {
    start + (end - start) * f64::from(g) / f64::from(g_max)
}
