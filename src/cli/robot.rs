//! The robot that moves, from the command line: how much room it needs, what cells near obstacles cost, how fast it is.

use crate::error::Notice;
use crate::scenario::{CostRule, Inflation, NAV2_RADIUS, Robot, ScenarioSpec};

use super::input;

/// The robot that moves. What is not given stays as the map's file says.
#[derive(clap::Args, Clone, Default)]
#[command(next_help_heading = "Robot")]
pub struct RobotArgs {
    /// Radius in metres: cells that are no farther from an obstacle are blocked; Nav2 pads its robot_radius: 0.22 there is
    /// 0.2255 here [default: the map's, else a point, with costs 0.1]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    robot_radius: Option<f64>,
    /// Cells near obstacles cost more, by the rule of a planner of Nav2: nav2-smac-2d or nav2-navfn; `check` counts as that planner
    /// does, all else what a path crosses [default: the map's, else no more]
    #[arg(long, value_name = "RULE", hide_possible_values = true, value_parser = input::cost_rules())]
    cost: Option<CostRule>,
    /// How far from obstacles cells cost more, in metres [default: the map's, else 0.55, as Nav2's]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    inflation_radius: Option<f64>,
    /// Cost scaling factor: how fast the cost falls off, per metre [default: the map's, else 10, as Nav2's]
    #[arg(long, value_name = "K", allow_negative_numbers = true)]
    cost_scaling: Option<f64>,
    /// nav2-smac-2d: its cost_travel_multiplier, 0 to 500 [default: the map's, else 2; newer versions of Nav2 have 1]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    cost_multiplier: Option<f64>,
    /// Metres per second, for the arrival time [default: the map's, else 1]
    #[arg(long, value_name = "M/S", allow_negative_numbers = true)]
    speed: Option<f64>,
    /// Seconds lost at each turn, for the arrival time [default: the map's, else 0]
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    seconds_per_turn: Option<f64>,
}

impl RobotArgs {
    /// Lets the arguments override a scenario's robot; tells which of Nav2's numbers were taken because none were given.
    pub fn apply(&self, spec: &mut ScenarioSpec) -> Option<Notice> {
        spec.vehicle.speed = self.speed.unwrap_or(spec.vehicle.speed);
        spec.vehicle.seconds_per_turn = self.seconds_per_turn.unwrap_or(spec.vehicle.seconds_per_turn);
        let known = spec.robot;
        let inflation = known.and_then(|robot| robot.inflation);
        if self.inflates() {
            let radius = self.robot_radius.or(known.map(|robot| robot.radius)).unwrap_or(NAV2_RADIUS);
            spec.robot = Some(Robot { radius, inflation: Some(self.inflation(inflation.unwrap_or(Inflation::NAV2))) });
            return if inflation.is_some() { None } else { self.assumed(known.is_none()) };
        }
        if let Some(radius) = self.robot_radius {
            spec.robot = Some(Robot { radius, inflation });
        }
        None
    }

    /// By which planner of Nav2 paths are to be judged.
    pub fn cost(&self) -> Option<CostRule> {
        self.cost
    }

    /// Whether anything is said of what cells near obstacles cost.
    fn inflates(&self) -> bool {
        self.cost.is_some() || [self.inflation_radius, self.cost_scaling, self.cost_multiplier].iter().any(Option::is_some)
    }

    fn inflation(&self, known: Inflation) -> Inflation {
        Inflation {
            radius: self.inflation_radius.unwrap_or(known.radius),
            cost_scaling: self.cost_scaling.unwrap_or(known.cost_scaling),
            rule: self.cost.unwrap_or(known.rule),
            multiplier: self.cost_multiplier.unwrap_or(known.multiplier),
        }
    }

    /// What nobody has given; of the radius only where the map has no robot either.
    fn assumed(&self, radius_too: bool) -> Option<Notice> {
        let Inflation { radius, cost_scaling, multiplier, rule } = Inflation::NAV2;
        let has_multiplier = self.cost.unwrap_or(rule) == CostRule::Nav2Smac2d;
        let usual = [
            (self.robot_radius.is_none() && radius_too, format!("robot_radius {NAV2_RADIUS} m")),
            (self.inflation_radius.is_none(), format!("inflation_radius {radius} m")),
            (self.cost_scaling.is_none(), format!("cost_scaling_factor {cost_scaling}")),
            (
                self.cost_multiplier.is_none() && has_multiplier,
                format!("cost_travel_multiplier {multiplier} (1 in newer versions)"),
            ),
        ];
        let taken: Vec<String> = usual.into_iter().filter_map(|(is_taken, what)| is_taken.then_some(what)).collect();
        let taken = taken.join(", ");
        (!taken.is_empty())
            .then(|| Notice::new("nav2-defaults", format!("taken as Nav2 has it by default: {taken}")).with("what", taken))
    }
}
