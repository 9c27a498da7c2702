//! `order`: in which order to visit places, by ants and, where there are few, with a proof.

use std::path::{Path, PathBuf};

use crate::aco::order_run::{ORDER_COLONY, OrderParams, OrderRun};
use crate::comparison::gap::relative_gap;
use crate::comparison::statistics::Summary;
use crate::error::{Error, FormatError, ParamError};
use crate::exact::order::Shape;
use crate::exact::order_problem::{LISTED_SOURCE, OrderProblem};
use crate::formats::{self, Kind, MAX_TEXT_BYTES, tsplib};
use crate::params::{Params, Value, Values};
use serde::Serialize;

use super::error::CliError;
use super::text::{self, TextOrJson, count, row};
use super::{Outcome, input};

/// Puts the places of a TSPLIB instance in an order, by an order colony and, for few places, with a proof
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  formicarium order berlin52.tsp --seed 7
  formicarium order att48.tsp --tour att48.opt.tour --runs 10
  formicarium order eil51.tsp --rule pseudo-random-proportional --q0 0.9 --ants 51
  formicarium order burma14.tsp --open --format json

Up to 17 places the best order is proven by Held and Karp. Beyond, a search goes on from the best run: it tells a cost below which no tour
lies and a better tour where it finds one, and proves the best where it comes so far. Tours begin with place 1; places are numbered as in the file.")]
pub struct Args {
    /// The instance (.tsp); `-` is standard input
    instance: PathBuf,
    /// A tour of it to compare with (.tour)
    #[arg(long, value_name = "FILE")]
    tour: Option<PathBuf>,
    /// The same seed gives the same run, bit for bit, on every machine
    #[arg(long, default_value_t = 1, allow_negative_numbers = true)]
    seed: u32,
    /// Runs with this seed and those after it
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1000))]
    runs: u32,
    /// random-proportional or pseudo-random-proportional [default: random-proportional]
    #[arg(long)]
    rule: Option<String>,
    /// Ants that build a tour in each iteration [default: 25]
    #[arg(long, allow_negative_numbers = true)]
    ants: Option<f64>,
    /// Iterations of a run [default: 200]
    #[arg(long, allow_negative_numbers = true)]
    iterations: Option<f64>,
    /// Weight of the trail [default: 1]
    #[arg(long, allow_negative_numbers = true)]
    alpha: Option<f64>,
    /// Weight of the heuristic, 1/cost [default: 5]
    #[arg(long, allow_negative_numbers = true)]
    beta: Option<f64>,
    /// The part of every trail that leaves in each iteration [default: 0.5]
    #[arg(long, allow_negative_numbers = true)]
    rho: Option<f64>,
    /// By the pseudo-random proportional rule, the probability of taking the best place [default: 0.7]
    #[arg(long, allow_negative_numbers = true)]
    q0: Option<f64>,
    /// Most 1-trees of the search beyond 17 places, 0 for no search [default: 200 to 20000, the fewer the more places]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(..=1_000_000))]
    trees: Option<u64>,
    /// Ends at the last place instead of returning to the first
    #[arg(long)]
    open: bool,
    /// text or json
    #[arg(long, value_enum, hide_possible_values = true, default_value_t = TextOrJson::Text)]
    format: TextOrJson,
}

impl Args {
    pub fn wants_json(&self) -> bool {
        self.format == TextOrJson::Json
    }

    fn params(&self) -> Result<OrderParams, ParamError> {
        let numbers = [
            ("ants", self.ants),
            ("iterations", self.iterations),
            ("alpha", self.alpha),
            ("beta", self.beta),
            ("rho", self.rho),
            ("q0", self.q0),
        ];
        let numbers = numbers.into_iter().filter_map(|(key, value)| Some((key.to_owned(), Value::Number(value?))));
        let rule = self.rule.iter().map(|rule| ("rule".to_owned(), Value::Text(rule.clone())));
        OrderParams::read(ORDER_COLONY, &numbers.chain(rule).collect::<Values>())
    }

    /// The seeds of all runs.
    fn seeds(&self) -> Result<std::ops::RangeInclusive<u32>, CliError> {
        let last = self.seed.checked_add(self.runs - 1);
        let last = last.ok_or_else(|| CliError::usage("the last seed is above 4294967295", "choose a smaller --seed or --runs"));
        Ok(self.seed..=last?)
    }

    fn problem(&self) -> Result<OrderProblem, CliError> {
        let mut problem = input::in_file(&self.instance, MAX_TEXT_BYTES, instance)?;
        if problem.name.is_empty() {
            problem.name = input::stem(&self.instance);
        }
        problem.shape = if self.open { Shape::Open } else { Shape::Closed };
        Ok(problem)
    }
}

/// An instance; of any other file it is said what it is.
fn instance(bytes: &[u8], name: &str) -> Result<OrderProblem, Error> {
    let read = tsplib::read_instance(bytes);
    let found = formats::recognise(bytes, name).map(|found| found.kind);
    match found {
        Err(error) if read.is_err() => Err(error.into()),
        Ok(kind) if read.is_err() && !matches!(kind, Kind::Tsplib | Kind::TsplibTour) => {
            let hint = "name an instance of TSPLIB (.tsp); of a map, plan a path: formicarium plan FILE --planner astar".into();
            Err(FormatError::Foreign { found: kind.name(), hint }.into())
        }
        _ => Ok(read?),
    }
}

pub fn run(args: &Args) -> Result<Outcome, CliError> {
    let (params, seeds, problem) = (args.params()?, args.seeds()?, args.problem()?);
    let tour = args.tour.as_deref().map(|path| tour(path, &problem)).transpose()?;
    let run = |seed| {
        let mut run = OrderRun::new(&problem, &params, seed);
        run.run();
        (seed, run)
    };
    let runs: Vec<(u32, OrderRun)> = seeds.map(run).collect();
    let bound = bound(&problem, &runs, args.trees.unwrap_or_else(|| problem.usual_trees()));
    let answer = Answer { bound, ..Answer::new(&problem, &params, &runs, tour) };
    let text = if args.wants_json() { text::json(&answer, 2) } else { answer.text() };
    Ok(Outcome::fine(text))
}

/// What a search of so many 1-trees finds and proves from the best run on.
fn bound(problem: &OrderProblem, runs: &[(u32, OrderRun)], most: u64) -> Option<Bound> {
    let best = runs.iter().filter_map(|(_, run)| run.best()).reduce(|best, next| if next.cost < best.cost { next } else { best });
    let mut search = problem.search(&best?.order).filter(|_| most > 0)?;
    search.go_on(most);
    Some(Bound {
        lower_bound: search.lower_bound(),
        cost: search.cost(),
        complete: search.is_proven(),
        trees: search.trees(),
        places: places(search.order()),
    })
}

fn tour(path: &Path, problem: &OrderProblem) -> Result<TourFile, CliError> {
    let order = input::in_file(path, MAX_TEXT_BYTES, |bytes, _| Ok(tsplib::read_tour(bytes, problem)?))?;
    Ok(TourFile { file: input::file_name(path), cost: problem.cost(&order) })
}

/// A tour that was named.
#[derive(Serialize)]
struct TourFile {
    file: String,
    cost: f64,
}

/// An order as places from 1, beginning with the first.
fn places(order: &[u32]) -> Vec<u32> {
    std::iter::once(1).chain(order.iter().map(|place| place + 2)).collect()
}

/// A tour and its cost.
#[derive(Serialize)]
struct Found {
    cost: f64,
    places: Vec<u32>,
}

/// What a search has found and proven.
#[derive(Serialize)]
struct Bound {
    lower_bound: f64,
    cost: f64,
    complete: bool,
    trees: u64,
    places: Vec<u32>,
}

/// One run.
#[derive(Serialize)]
struct RunResult {
    seed: u32,
    cost: f64,
    iteration: u32,
    gap: Option<f64>,
    places: Vec<u32>,
    improvements: Vec<(u32, f64)>,
    digest: String,
}

/// What `--format json` prints; docs/formats.md describes it.
#[derive(Serialize)]
struct Answer {
    format: &'static str,
    name: String,
    comment: String,
    places: usize,
    weight_type: String,
    closed: bool,
    params: Values,
    exact: Option<Found>,
    unproven_because: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bound: Option<Bound>,
    listed_optimum: Option<f64>,
    tour: Option<TourFile>,
    runs: Vec<RunResult>,
    summary: Option<Summary>,
}

impl Answer {
    fn new(problem: &OrderProblem, params: &OrderParams, runs: &[(u32, OrderRun)], tour: Option<TourFile>) -> Self {
        let exact = problem.prove().map(|proven| Found { cost: proven.cost, places: places(&proven.order) });
        let listed_optimum = problem.listed_optimum();
        let best = exact.as_ref().map(|found| found.cost).or(listed_optimum);
        let result = |(seed, run): &(u32, OrderRun)| {
            let found = run.best()?;
            Some(RunResult {
                seed: *seed,
                cost: found.cost,
                iteration: found.iteration,
                gap: best.map(|best| relative_gap(found.cost, best)),
                places: places(&found.order),
                improvements: run.improvements().to_vec(),
                digest: run.digest().hex(),
            })
        };
        let runs: Vec<RunResult> = runs.iter().filter_map(result).collect();
        let summary = Summary::of(&runs.iter().map(|run| run.cost).collect::<Vec<_>>());
        Self {
            format: "formicarium/order@1",
            name: problem.name.clone(),
            comment: problem.comment.clone(),
            places: problem.len(),
            weight_type: problem.weight_type.clone(),
            closed: problem.shape == Shape::Closed,
            params: params.values(),
            exact,
            unproven_because: problem.unproven_because(),
            bound: None,
            listed_optimum,
            tour,
            runs,
            summary,
        }
    }

    fn text(&self) -> String {
        let shape = if self.closed { "closed tours" } else { "open tours" };
        let mut out = format!("{} ({} places, {}, {shape})\n\n", self.name, self.places, self.weight_type);
        if !self.comment.is_empty() {
            row(&mut out, "comment", &self.comment);
        }
        match (&self.exact, &self.unproven_because) {
            (Some(found), _) => row(&mut out, "exact", format!("{}, proven by Held and Karp", found.cost)),
            (None, why) => row(&mut out, "exact", format!("unknown: {}", why.as_deref().unwrap_or(""))),
        }
        self.bound_text(&mut out);
        if let Some(listed) = self.listed_optimum {
            row(&mut out, "listed", format!("{listed}, the listed optimum ({LISTED_SOURCE})"));
        }
        if let Some(tour) = &self.tour {
            row(&mut out, "tour", format!("{}, length of the tour in {}", tour.cost, tour.file));
        }
        self.runs_text(&mut out);
        out
    }

    /// What the search has proven.
    fn bound_text(&self, out: &mut String) {
        let Some(bound) = &self.bound else { return };
        let trees = count(bound.trees, "1-tree", "1-trees");
        let said = if bound.complete {
            format!("no tour costs less than {}, and one costs that: {trees}", bound.cost)
        } else {
            let gap = text::percent(relative_gap(bound.cost, bound.lower_bound));
            format!("no tour costs less than {}; one costs {}, {gap} more: stopped after {trees}", bound.lower_bound, bound.cost)
        };
        row(out, "bound", said);
        row(out, "", bound.places.iter().map(u32::to_string).collect::<Vec<_>>().join(" → "));
    }

    /// The best run, and where there are several what all of them reached.
    fn runs_text(&self, out: &mut String) {
        let best = self.runs.iter().reduce(|best, run| if run.cost < best.cost { run } else { best });
        let (Some(best), Some(all)) = (best, &self.summary) else { return };
        row(out, "ants", format!("{}{}", best.cost, best.gap.map_or(String::new(), |gap| self.above(gap))));
        if let Some(tour) = &self.tour {
            let percent = 100.0 * (best.cost / tour.cost - 1.0);
            row(out, "", format!("{percent:+.2} % from the tour in {}", tour.file));
        }
        row(out, "found in", format!("iteration {} of {}", best.iteration, self.params["iterations"]));
        if self.runs.len() > 1 {
            let runs = count(self.runs.len() as u64, "run", "runs");
            row(out, "all runs", format!("{runs}: best {}, median {}, worst {}", all.least, all.median, all.greatest));
        }
        row(out, "order", best.places.iter().map(u32::to_string).collect::<Vec<_>>().join(" → "));
        row(out, "seed", best.seed);
        row(out, "digest", &best.digest);
    }

    fn above(&self, gap: f64) -> String {
        let of = if self.exact.is_some() { "proven" } else { "listed" };
        format!(", {} above the {of} optimum", text::percent(gap))
    }
}
