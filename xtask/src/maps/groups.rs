//! What the suite of maps consists of: the only place where it is written down.

use Ends::{Alternating, Corners, CornersBySteps16, OfMap, Slices};

/// Maps that stand for one map, or one kind of map, of a publication.
pub struct Group {
    /// The beginning of its files' names.
    pub name: &'static str,
    pub generator: &'static str,
    /// Columns and rows.
    pub size: (u32, u32),
    /// Absent: the generator's own, as for terrains.
    pub density: Option<&'static str>,
    /// How many maps.
    pub maps: usize,
    /// Seeds are tried in order from here on.
    pub first_seed: u32,
    pub ends: Ends,
    pub facts: &'static [Fact],
}

/// Where start and goals are.
pub enum Ends {
    /// From the upper-left to the lower-right corner.
    Corners,
    /// The same with 16 moves.
    CornersBySteps16,
    /// The same on maps of odd numbers, the other way round on those of even ones: the publication leaves it open.
    Alternating,
    /// Those of a map in experiments/maps.
    OfMap(&'static str),
    /// By slices, from a cell to another.
    Slices(&'static str, &'static str),
}

/// An optimum that is proven of every map, and what the publication says of it.
pub struct Fact {
    /// The exact planner, with the arguments that it needs.
    pub planner: &'static [&'static str],
    /// What it finds.
    pub what: &'static str,
    /// The least published length, as it is printed; absent where nothing is known.
    pub most: Option<&'static str>,
}

const fn steps(most: &'static str) -> Fact {
    Fact { planner: &["astar"], what: "by steps", most: Some(most) }
}

const fn polyline(most: &'static str) -> Fact {
    Fact { planner: &["any-angle"], what: "polyline", most: Some(most) }
}

const fn cost(most: &'static str) -> Fact {
    Fact { planner: &["slices-exact"], what: "cost by slices", most: Some(most) }
}

const fn terrain(name: &'static str, side: u32, from: &'static str, to: &'static str, facts: &'static [Fact]) -> Group {
    let (size, ends) = ((side, side), Slices(from, to));
    Group { name, generator: "hills", size, density: None, maps: 8, first_seed: 2, ends, facts }
}

const fn of_walls(
    name: &'static str,
    generator: &'static str,
    side: u32,
    maps: usize,
    density: &'static str,
    ends: Ends,
) -> Group {
    Group { name, generator, size: (side, side), density: Some(density), maps, first_seed: 1, ends, facts: &[] }
}

pub const GROUPS: [Group; 12] = [
    Group { facts: &[polyline("27.626"), steps("30.275")], ..of_walls("ship-20x20", "blocks", 20, 10, "0.2", Corners) },
    Group { facts: &[polyline("42.608"), steps("47.827")], ..of_walls("ship-30x30", "blocks", 30, 10, "0.2", Corners) },
    Group {
        size: (40, 30),
        facts: &[polyline("52.6525"), steps("63.2843")],
        ..of_walls("engine-room", "blocks", 0, 10, "0.3", Corners)
    },
    Group { facts: &[steps("45.108")], ..of_walls("environment-1", "bars", 20, 16, "0.3", Alternating) },
    Group { facts: &[steps("45.689")], ..of_walls("environment-2", "random", 20, 16, "0.35", Alternating) },
    // Environments as open as ACOMSP needs to arrive, which the paper says it does.
    Group { facts: &[steps("45.108")], ..of_walls("environment-open", "random", 20, 24, "0.2", Alternating) },
    Group { facts: &[steps("37.79")], ..of_walls("criss-cross", "bars", 20, 16, "0.25", Corners) },
    Group {
        facts: &[Fact {
            planner: &["tour-exact", "--set", "objective=length"],
            what: "shortest tour by steps",
            most: Some("41.04"),
        }],
        ..of_walls("fires", "blocks", 20, 16, "0.2", OfMap("fire-20x20"))
    },
    terrain("hills-20", 21, "0,10", "20,8", &[cost("112.5")]),
    terrain("hills-30", 31, "0,15", "30,11", &[cost("161.7")]),
    terrain("hills-50", 51, "0,25", "50,19", &[cost("241.2")]),
    Group {
        ends: CornersBySteps16,
        ..terrain("hills-surface", 65, "", "", &[Fact { planner: &["astar"], what: "along the ground", most: None }])
    },
];

impl Group {
    /// The ends of the map of a number, as arguments of `generate`.
    pub fn ends(&self, number: usize) -> Vec<String> {
        let (right, bottom) = (self.size.0 - 1, self.size.1 - 1);
        let is_forward = !matches!(self.ends, Alternating) || number % 2 == 1;
        let corners = ["0,0".to_owned(), format!("{right},{bottom}")];
        let between = |[from, to]: [String; 2]| vec!["--from".into(), from, "--to".into(), to];
        match self.ends {
            Corners | Alternating if is_forward => between(corners),
            Corners | Alternating => between([corners[1].clone(), corners[0].clone()]),
            CornersBySteps16 => [between(corners), vec!["--moves".into(), "16".into()]].concat(),
            OfMap(name) => vec!["--ends-of".into(), format!("experiments/maps/{name}.json")],
            Slices(from, to) => [between([from.into(), to.into()]), vec!["--model".into(), "slices".into()]].concat(),
        }
    }
}
