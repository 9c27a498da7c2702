//! English.

use super::Claims;
use crate::comparison::over_maps::{OverallVerdict, VerdictCounts};
use crate::comparison::verdict::Verdict;
use crate::planner::PaperReading;

pub(in crate::comparison::report::words) const CLAIMS: Claims = Claims {
    title: "Claims",
    by_map: "Map by map",
    columns: |confidence| {
        let (effect, medians) = (format!("effect [{confidence} %]"), format!("difference of medians [{confidence} %]"));
        let before = ["claim", "map", "measure", "claimed", "baseline → improved"].map(String::from);
        let [claim, map, measure, claimed, values] = before;
        let means = format!("of means [{confidence} %]");
        [claim, map, measure, claimed, values, effect, medians, means, "better".into(), "p".into(), "verdict".into()]
    },
    against: |[says, improved, baseline]| format!("{says}: {improved} against {baseline}"),
    to_target: |measure, near, axis| format!("{measure} to within {near}, {}", axis.words()),
    never: "never",
    runs: |[improved, baseline], paired| match paired {
        true => format!(", {improved} pairs"),
        false => format!(", {improved} and {baseline} runs"),
    },
    points: |number| format!("{number} points"),
    verdict,
    totals: |counts| {
        let VerdictCounts { reproduced, direction, partly, equivalent, not, opposite, cannot_tell } = counts;
        let all = reproduced + direction + partly + equivalent + not + opposite + cannot_tell;
        format!(
            "Of {all} comparisons on single maps: {reproduced} reproduced, {direction} in direction, {partly} partly, {equivalent} without \
             a relevant difference, {not} without a difference shown, {opposite} the opposite, {cannot_tell} that cannot be told."
        )
    },
    over_columns: |confidence| {
        let effect = format!("median effect [{confidence} %]");
        let before = ["claim", "better on", "by map", "signs + / 0 / −, p"].map(String::from);
        let [claim, better, by_map, signs] = before;
        [claim, better, by_map, signs, effect, "verdict over maps".into()]
    },
    on_maps: |some, all| format!("{some} of {all} maps"),
    counts: |counts| {
        let VerdictCounts { reproduced, direction, partly, equivalent, not, opposite, cannot_tell } = *counts;
        let named = [
            (reproduced, "reproduced"),
            (direction, "direction"),
            (partly, "partly"),
            (equivalent, "no relevant difference"),
            (not, "no difference shown"),
            (opposite, "opposite"),
            (cannot_tell, "cannot tell"),
        ];
        let told = named.into_iter().filter(|(count, _)| *count > 0);
        told.map(|(count, name)| format!("{count} {name}")).collect::<Vec<_>>().join(", ")
    },
    overall: |overall, has_size, fewest| match overall {
        OverallVerdict::DependsOnMap => "**depends on the map**".into(),
        OverallVerdict::CannotTell => format!("**cannot tell**: fewer than {fewest} maps"),
        like => like.as_of_one().map_or_else(String::new, |one| verdict(one, has_size)),
    },
    about: "claims over maps: on how many maps the difference is certain and relevant, with 95 % of that share; p of the sign test; the median \
            of the maps' effects, as a part of the baseline's value, with a distribution-free interval of at least 95 %",
    readings_title: "Claims by reading",
    readings_columns: ["claim", "measure"],
    reading: |reading| match reading {
        PaperReading::Printed => "as printed",
        PaperReading::AsRead => "as we read it",
        PaperReading::SecondReading => "second reading",
    },
    readings_about: "claims by the reading of the publication: the verdict over maps, on how many maps the difference is certain and relevant, and \
                     the median of the maps' effects",
    unfit_title: "Maps that cannot stand for the paper's",
    unfit_columns: ["map", "here", "the publication says it in"],
    optimum_above: |optimum, most| format!("the exact optimum is {optimum}; published is {most}"),
    no_path: |most| format!("no path exists; published is one of {most}"),
    does_not_arrive: |[entry, share, least]| {
        format!("{entry} finds a path in {share} of its runs; it should in {least} at least")
    },
};

fn verdict(verdict: Verdict, has_size: bool) -> String {
    match verdict {
        Verdict::Reproduced if !has_size => "**reproduced** (no size is claimed)".into(),
        Verdict::Reproduced => "**reproduced**".into(),
        Verdict::Direction => "**direction reproduced**, size cannot be told".into(),
        Verdict::Partly => "**partly**: less than half of the size".into(),
        Verdict::Equivalent => "**no relevant difference**".into(),
        Verdict::Not => "**no difference shown**".into(),
        Verdict::Opposite => "**the opposite**".into(),
        Verdict::CannotTell(why) => format!("**cannot tell**: {}", why.words()),
    }
}
