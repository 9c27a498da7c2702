//! The naive walk: pow for every neighbour of every step, a flag per cell for the tabu list, one ant after another.
//!
//! The yardstick of the kernel's speed (`benches/walk.rs`) and of its numbers (`tests/reference_kernel.rs`: equal digests). Written
//! from the formulas alone; it shares with the engine only what defines the numbers: streams, trails, the order of summation.

use std::sync::Arc;

use formicarium::aco::heuristic::Heuristic;
use formicarium::aco::trails::Trails;
use formicarium::digest::Digest;
use formicarium::map::{Cell, Direction, opposite, step_length};
use formicarium::rng::{Streams, unit_f32};
use formicarium::scenario::Scenario;
use rand::Rng;

/// Ant System with backtracking, m ants, α = 1, Q = 1, τ0 = 1, written naively.
pub struct Naive {
    pub scenario: Arc<Scenario>,
    pub ants: u32,
    pub beta: f64,
    pub rho: f64,
    pub heuristic: Heuristic,
    pub max_moves: u32,
    streams: Streams,
    trails: Trails,
    iteration: u32,
    best: Option<(Vec<Direction>, f64)>,
    history: Vec<(Option<f64>, Vec<f64>)>,
    pub moves: u64,
}

impl Naive {
    pub fn new(scenario: Arc<Scenario>, ants: u32, beta: f64, rho: f64, heuristic: Heuristic, seed: u32) -> Self {
        let max_moves = 4 * (scenario.grid.width() + scenario.grid.height());
        let trails = Trails::new(scenario.grid.len(), 1.0);
        let streams = Streams::new(u64::from(seed), "ant-system", 0);
        let (best, history) = (None, Vec::new());
        Self { scenario, ants, beta, rho, heuristic, max_moves, streams, trails, iteration: 0, best, history, moves: 0 }
    }

    pub fn iterate(&mut self) {
        self.iteration += 1;
        let walks: Vec<Option<Vec<Direction>>> = (0..self.ants).map(|k| self.walk(k)).collect();
        let length = |w: &[Direction]| {
            let straight = w.iter().filter(|&&d| step_length(d) == 1.0).count() as u32;
            formicarium::map::counted_length(straight, w.len() as u32 - straight)
        };
        let lengths: Vec<f64> = walks.iter().flatten().map(|w| length(w)).collect();
        self.trails.evaporate(self.rho);
        for walk in walks.into_iter().flatten() {
            let l = length(&walk);
            if self.best.as_ref().is_none_or(|b| l < b.1) {
                self.best = Some((walk.clone(), l));
            }
            let mut at = self.scenario.start;
            for d in walk {
                self.trails.deposit(at, d, 1.0 / l);
                at = self.scenario.moves.step(at, d);
            }
        }
        self.history.push((self.best.as_ref().map(|b| b.1), lengths));
    }

    fn walk(&mut self, ant: u32) -> Option<Vec<Direction>> {
        let mut stream = self.streams.ant(self.iteration, ant);
        let (mut at, mut way, mut moves) = (self.scenario.start, Vec::new(), 0);
        let mut visited = vec![false; self.scenario.grid.len()];
        visited[at as usize] = true;
        loop {
            moves += 1;
            self.moves += 1;
            let weights = self.weights(at, &visited);
            let total: f32 = weights.iter().sum();
            if total > 0.0 {
                let threshold = unit_f32(stream.next_u32()) * total;
                let mut sum = 0.0;
                let d = weights
                    .iter()
                    .position(|w| {
                        sum += w;
                        sum > threshold
                    })
                    .expect("u < 1") as Direction;
                way.push(d);
                at = self.scenario.moves.step(at, d);
                visited[at as usize] = true;
                if at == self.scenario.goal {
                    return Some(way);
                }
            } else {
                at = self.scenario.moves.step(at, opposite(way.pop()?));
            }
            if moves >= self.max_moves {
                return None;
            }
        }
    }

    /// (τ/τ_max)·(η/η_max)^β of every neighbour that is free and not visited.
    fn weights(&self, at: Cell, visited: &[bool]) -> [f32; 8] {
        let s = &*self.scenario;
        let eta = |d: Direction| self.heuristic.of(s, at, d, s.moves.step(at, d));
        let largest = s.moves.directions(at).map(eta).fold(0.0, f64::max);
        let tau = |d: Direction| self.trails.relative(at)[d as usize];
        let strongest = s.moves.directions(at).map(tau).fold(0.0, f32::max);
        let mut weights = [0.0; 8];
        for d in s.moves.directions(at).filter(|&d| !visited[s.moves.step(at, d) as usize]) {
            let seen = (libm::pow(eta(d) / largest, self.beta) as f32).max(1e-30);
            let trail = libm::pow(f64::from(tau(d) / strongest), 1.0) as f32;
            weights[d as usize] = (trail * seen).max(1e-30);
        }
        weights
    }

    pub fn digest(&self) -> String {
        let mut digest = Digest::default();
        for (i, (best, lengths)) in self.history.iter().enumerate() {
            let sum: f64 = lengths.iter().fold(0.0, |a, b| a + b);
            let some = |v: f64| if lengths.is_empty() { f64::NAN } else { v };
            digest.u32(i as u32 + 1);
            digest.f64(best.unwrap_or(f64::NAN));
            digest.f64(some(lengths.iter().copied().fold(f64::INFINITY, f64::min)));
            digest.f64(some(sum / lengths.len() as f64));
            digest.f64(some(lengths.iter().copied().fold(0.0, f64::max)));
            digest.u32(lengths.len() as u32);
        }
        if let Some((way, length)) = &self.best {
            let mut at = self.scenario.start;
            digest.u32(way.len() as u32 + 1);
            digest.u32(at);
            for &d in way {
                at = self.scenario.moves.step(at, d);
                digest.u32(at);
            }
            digest.f64(*length);
        }
        digest.hex()
    }
}
