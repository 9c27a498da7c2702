//! Simplified Chinese.

use super::Claims;
use crate::comparison::over_maps::{OverallVerdict, VerdictCounts};
use crate::comparison::report::words::zh_cn::axis;
use crate::comparison::verdict::{Verdict, WhyNot};
use crate::planner::PaperReading;

pub(in crate::comparison::report::words) const CLAIMS: Claims = Claims {
    title: "主张",
    by_map: "逐张地图",
    columns: |confidence| {
        let (effect, medians) = (format!("效应 [{confidence}%]"), format!("中位数之差 [{confidence}%]"));
        let before = ["主张", "地图", "衡量标准", "所称", "基线 → 改进项"].map(String::from);
        let [claim, map, measure, claimed, values] = before;
        let means = format!("均值之差 [{confidence}%]");
        [claim, map, measure, claimed, values, effect, medians, means, "更好".into(), "p".into(), "判定".into()]
    },
    against: |[says, improved, baseline]| format!("{says}：{improved} 对比 {baseline}"),
    to_target: |measure, near, on| format!("达到 {near} 以内的{measure}，{}", axis(on)),
    never: "从未达到",
    runs: |[improved, baseline], paired| match paired {
        true => format!("，{improved} 对"),
        false => format!("，{improved} 与 {baseline} 次运行"),
    },
    points: |number| format!("{number} 个百分点"),
    verdict,
    totals: |counts| {
        let VerdictCounts { reproduced, direction, partly, equivalent, not, opposite, cannot_tell } = counts;
        let all = reproduced + direction + partly + equivalent + not + opposite + cannot_tell;
        format!(
            "单张地图上共 {all} 项比较：{reproduced} 项已复现，{direction} 项方向已复现，{partly} 项部分复现，{equivalent} 项无实质差别，\
             {not} 项未显示差别，{opposite} 项结果相反，{cannot_tell} 项无法判断。"
        )
    },
    over_columns: |confidence| {
        let effect = format!("效应的中位数 [{confidence}%]");
        let before = ["主张", "更好的地图", "各地图的判定", "符号 + / 0 / −，p"].map(String::from);
        let [claim, better, by_map, signs] = before;
        [claim, better, by_map, signs, effect, "所有地图的判定".into()]
    },
    on_maps: |some, all| format!("{all} 张地图中的 {some} 张"),
    counts: |counts| {
        let VerdictCounts { reproduced, direction, partly, equivalent, not, opposite, cannot_tell } = *counts;
        let named = [
            (reproduced, "已复现"),
            (direction, "方向已复现"),
            (partly, "部分复现"),
            (equivalent, "无实质差别"),
            (not, "未显示差别"),
            (opposite, "结果相反"),
            (cannot_tell, "无法判断"),
        ];
        let told = named.into_iter().filter(|(count, _)| *count > 0);
        told.map(|(count, name)| format!("{name} {count}")).collect::<Vec<_>>().join("，")
    },
    overall: |overall, has_size, fewest| match overall {
        OverallVerdict::DependsOnMap => "**取决于地图**".into(),
        OverallVerdict::CannotTell => format!("**无法判断**：地图少于 {fewest} 张"),
        like => like.as_of_one().map_or_else(String::new, |one| verdict(one, has_size)),
    },
    about: "各项主张在所有地图上的结果：差别确定且有实质意义的地图数，及该比例的 95% 区间；符号检验的 p；各地图效应（占基线值的比例）的\
            中位数，及置信度不低于 95% 的与分布无关的区间",
    readings_title: "各种读法下的主张",
    readings_columns: ["主张", "衡量标准"],
    reading: |reading| match reading {
        PaperReading::Printed => "按印刷公式",
        PaperReading::AsRead => "按我们的理解",
        PaperReading::SecondReading => "第二种读法",
    },
    readings_about: "论文各种读法下的主张：所有地图的判定、差别确定且有实质意义的地图数，以及各地图效应的中位数",
    unfit_title: "不能代表论文地图的地图",
    unfit_columns: ["地图", "此处", "论文出处"],
    optimum_above: |optimum, most| format!("精确最优为 {optimum}，论文报告 {most}"),
    no_path: |most| format!("不存在路径，论文报告 {most}"),
    does_not_arrive: |[entry, share, least]| format!("{entry} 在 {share} 的运行中找到路径，至少应为 {least}"),
};

fn verdict(verdict: Verdict, has_size: bool) -> String {
    match verdict {
        Verdict::Reproduced if !has_size => "**已复现**（没有所称的大小）".into(),
        Verdict::Reproduced => "**已复现**".into(),
        Verdict::Direction => "**方向已复现**，大小无法判断".into(),
        Verdict::Partly => "**部分复现**：不到所称大小的一半".into(),
        Verdict::Equivalent => "**无实质差别**".into(),
        Verdict::Not => "**未显示差别**".into(),
        Verdict::Opposite => "**结果相反**".into(),
        Verdict::CannotTell(why) => format!("**无法判断**：{}", why_not(why)),
    }
}

fn why_not(why: WhyNot) -> &'static str {
    match why {
        WhyNot::Contradicted => "此地图与论文对其地图的说明矛盾",
        WhyNot::SameMap => "与前面的一张地图相同",
        WhyNot::Impossible => "两者之一在此地图上有不可能的运行",
        WhyNot::NoCommonSeed => "没有两次运行种子相同",
        WhyNot::NotRun => "两者之一无法运行",
        WhyNot::NoBaseline => "基线有半数或更多运行未找到路径",
        WhyNot::TooFewRuns => "可比较的运行太少",
        WhyNot::NoRoom => "基线几乎所有运行已是最优",
        WhyNot::FirstStage => "两者之一有许多运行的最优出自第一阶段",
        WhyNot::OtherObjective => "两者的优化目标不同",
        WhyNot::NoTarget => "没有已知的目标",
        WhyNot::NoEffort => "有运行的工作量未知",
        WhyNot::NeitherReaches => "两者都没有运行达到目标",
    }
}
