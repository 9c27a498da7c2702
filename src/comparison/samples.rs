//! The runs of a comparison by map and entry, each sample in the order of its seeds.

use super::Comparison;
use super::measure::RunMeasure;
use super::row::Row;
use super::run::Timed;
use crate::exact::Reference;

/// A run, and when its improvements came.
#[derive(Debug, Clone, Copy)]
pub struct Seen<'a> {
    /// The run.
    pub row: &'a Row,
    /// As [`Timed::seconds`]; empty where nobody has looked at a clock.
    pub seconds: &'a [f64],
}

impl<'a> From<&'a Row> for Seen<'a> {
    fn from(row: &'a Row) -> Self {
        Self { row, seconds: &[] }
    }
}

impl<'a> From<&'a Timed> for Seen<'a> {
    fn from(timed: &'a Timed) -> Self {
        Self { row: &timed.row, seconds: &timed.seconds }
    }
}

/// All runs that are known.
#[derive(Debug)]
pub struct Samples<'a> {
    comparison: &'a Comparison,
    /// By instance and entry.
    runs: Vec<Vec<Vec<Seen<'a>>>>,
}

impl<'a> Samples<'a> {
    /// Sorts runs; the imported ones must be among them ([`Comparison::all_rows`]). Runs of no entry or map are left out.
    pub fn new(comparison: &'a Comparison, runs: impl IntoIterator<Item = Seen<'a>>) -> Self {
        let mut sorted = vec![vec![Vec::new(); comparison.question.entries.len()]; comparison.maps.len()];
        for seen in runs {
            let task = seen.row.task;
            if let Some(sample) = sorted.get_mut(task.instance).and_then(|entries| entries.get_mut(task.entry)) {
                sample.push(seen);
            }
        }
        sorted.iter_mut().flatten().for_each(|sample| sample.sort_by_key(|seen| seen.row.task.seed));
        Self { comparison, runs: sorted }
    }

    /// What was asked, with its maps.
    pub fn comparison(&self) -> &'a Comparison {
        self.comparison
    }

    /// The runs of an entry on a map, by seed.
    pub fn of(&self, instance: usize, entry: usize) -> &[Seen<'a>] {
        self.runs.get(instance).and_then(|entries| entries.get(entry)).map_or(&[], Vec::as_slice)
    }

    /// How many of them are impossible ([`Comparison::impossible`]). Where any is, the entry is compared with nobody on this map: its rules
    /// were others.
    pub fn impossible(&self, instance: usize, entry: usize) -> usize {
        self.of(instance, entry).iter().filter(|seen| self.comparison.impossible(seen.row)).count()
    }

    /// A measure of these runs by seed, infinite for those without a path; runs that do not tell it are left out.
    pub fn values(&self, instance: usize, entry: usize, measure: RunMeasure) -> Vec<(u32, f64)> {
        let value = |seen: &Seen| Some((seen.row.task.seed, self.comparison.value(seen.row, measure)?));
        self.of(instance, entry).iter().filter_map(value).collect()
    }

    /// Whether runs of two entries with one seed draw alike: one planner with two settings. Two planners draw from different streams, and of
    /// results from elsewhere nobody can tell.
    pub fn are_paired(&self, entries: [usize; 2]) -> bool {
        let [a, b] = entries.map(|entry| self.comparison.question.entries.get(entry).and_then(|e| e.planner.as_ref()));
        a.is_some() && a == b
    }

    /// The best value on a map by a measure: the reference, and where some of it is not proven, the best of the runs if they are better. None
    /// where entries weigh the same terms differently: their sums are no one measure.
    pub fn best_known(&self, instance: usize, measure: RunMeasure) -> Option<f64> {
        let map = &self.comparison.maps[instance];
        let meant = self.entries(|entry| map.objective(entry).is_some_and(|o| map.measure_of(o) == measure));
        let sum = |&entry: &usize| map.aim(entry).and_then(|aim| aim.sum);
        if meant.windows(2).any(|two| sum(&two[0]) != sum(&two[1])) { None } else { self.best(instance, &meant) }
    }

    /// The same of the entries that make the same small as this one: of steps, not of polylines.
    pub fn best_like(&self, instance: usize, entry: usize) -> Option<f64> {
        let map = &self.comparison.maps[instance];
        let meant = self.entries(|other| map.aim(other).is_some() && map.aim(other) == map.aim(entry));
        self.best(instance, &meant)
    }

    /// The entries of which something holds.
    fn entries(&self, is_meant: impl Fn(usize) -> bool) -> Vec<usize> {
        (0..self.comparison.question.entries.len()).filter(|&entry| is_meant(entry)).collect()
    }

    fn best(&self, instance: usize, meant: &[usize]) -> Option<f64> {
        let references = || meant.iter().map(|&entry| self.comparison.maps[instance].reference(entry));
        let known = references().filter_map(Reference::value).reduce(f64::min);
        if !meant.is_empty() && references().all(Reference::is_proven) {
            return known;
        }
        let values = meant.iter().flat_map(|&entry| self.of(instance, entry)).filter_map(|seen| Some(seen.row.found?.value));
        values.chain(known).reduce(f64::min)
    }
}

/// The values of the seeds that both samples have.
pub(super) fn paired(first: &[(u32, f64)], second: &[(u32, f64)]) -> Vec<(f64, f64)> {
    let mut rest = second.iter().peekable();
    let pair = |&(seed, value): &(u32, f64)| {
        while rest.next_if(|other| other.0 < seed).is_some() {}
        rest.next_if(|other| other.0 == seed).map(|other| (value, other.1))
    };
    first.iter().filter_map(pair).collect()
}

/// Values without their seeds.
pub(super) fn without_seeds(sample: &[(u32, f64)]) -> Vec<f64> {
    sample.iter().map(|&(_, value)| value).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_have_one_seed() {
        let first = [(1, 10.0), (2, 20.0), (4, 40.0), (9, 90.0)];
        let second = [(2, 21.0), (3, 31.0), (4, 41.0), (7, 71.0)];
        assert_eq!(paired(&first, &second), [(20.0, 21.0), (40.0, 41.0)]);
        assert_eq!(paired(&first, &[]), []);
        assert_eq!(paired(&[(5, 1.0), (5, 2.0)], &[(5, 3.0)]), [(1.0, 3.0)]);
    }
}
