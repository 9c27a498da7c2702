//! Simplified Chinese, with the terms of docs/zh and of the page.

use super::{Ablation, Fronts, Latex, Matrix, Names, Page, Signs, Summary, Tests, Words, claims};
use crate::comparison::analysis::{NoRunningTime, RunCounts};
use crate::comparison::budget::{Axis, Budget};
use crate::comparison::claim::Statistic;
use crate::comparison::measure::RunMeasure;
use crate::comparison::question::Role;
use crate::planner::Objective;

pub(super) static WORDS: Words = Words {
    signs: Signs {
        list: "、",
        parts: "；",
        comma: "，",
        next: "。",
        end: "。",
        percent: |number| format!("{number}%"),
        about: |name, said| format!("{name}：{said}"),
        beside: |what, beside| format!("{what}（{beside}）"),
        part_of: |part, whole| format!("{part} / {whole}"),
    },
    names: Names {
        measure,
        objective,
        axis,
        role: |role| match role {
            Role::Baseline => "基线",
            Role::Improved => "改进项",
            Role::Other => "",
        },
        no_running_time,
        statistic: |statistic| match statistic {
            Statistic::Mean => "均值",
            Statistic::Median => "中位数",
        },
        from_elsewhere: |name| format!("{name}（外部结果）"),
        no_path: "无路径",
        not_run: "未运行",
        impossible_runs: |runs, entry| format!("{entry}（{runs} 次运行）"),
        impossible: |runs| format!("†：在此地图上不可能，优于已证明的最优值：{runs}；因此不参与排名和检验，也不用粗体"),
        moves: |moves| format!("{moves} 方向移动"),
        on_surface: "，沿地面",
        on_weighted: "，加权地面",
        robot: |radius| format!("，机器人半径 {radius} 米"),
        by_slices: |[levels, level, aside, climb]| {
            format!("按切片，{levels} 层，每层 {level} 米，|Δy| ≤ {aside}，|Δh| ≤ {climb}")
        },
        engine: ENGINE,
        setting,
        makes_small: |objectives| format!("优化目标：{objectives}"),
    },
    page: Page {
        paper: |paper| format!("论文：{paper}。"),
        made_by: "由 ",
        made_with: |setting| format!(" 生成，{setting}"),
        how_to_read: "读法见 docs/zh/methodology.md。",
        entry: "参评项",
        runs: "运行的内容",
        results_from: |file| format!("{file} 中的结果"),
        cannot_run: |why| format!("未运行：{why}"),
        no_planner: "没有规划器",
        published: |measure| format!("论文报告：{measure} / 转弯 / 迭代"),
        columns: [
            "找到路径",
            "最好",
            "中位数",
            "IQR",
            "均值 ± 标准差 [95%]",
            "最优路径所在迭代：中位数（IQR）",
            "找到最优前构造的路径数：中位数",
            "转弯：中位数（IQR）",
            "最优",
        ],
        exact_optimum: |objective| format!("精确最优，{objective}"),
        best_known: |objective| format!("已知最优（未证明），{objective}"),
        best_of_runs: |objective| format!("这些运行中最好的（没有证明），{objective}"),
        exact: "精确规划",
        no_path_exists: "不存在路径",
        none: "无",
        published_impossible: |value, optimum| {
            format!("在此地图和此移动规则下，论文报告的 {value} 不可能出现：精确最优为 {optimum}。")
        },
        runs_impossible: |part, whole| {
            format!(
                "{whole} 次运行中有 {part} 次在此地图和此移动规则下不可能：优于精确最优，或根本没有路径；因此该参评项不参与排名和检验。"
            )
        },
        stand_in: "若地图只是代表论文的地图，这只说明两张地图不同。",
    },
    claims: claims::ZH_CN,
    ablation: Ablation {
        title: "各组件的作用",
        about: |level| {
            format!(
                "每次只去掉一个组件，其余不变；差值为相同种子下去掉该组件的运行减去完整规划器的运行，因此越大说明该组件越有益。Wilcoxon \
                 检验的 p 按该地图的各组件作 Holm 校正后低于 {level} 时，该组件起作用；两个组件同时去掉会怎样，这里没有说明。"
            )
        },
        map: |[map, what, full]| format!("{map}：完整规划器的{what}为 {full}"),
        columns: |what, confidence| {
            let (means, medians) = (format!("均值之差 [{confidence}%]"), format!("中位数之差 [{confidence}%]"));
            let [path, worse, leaning, holm, finding] = ["有路径的运行", "更差", "倾向", "Holm 校正 p", "结论"].map(String::from);
            ["去掉".into(), what.into(), "变化".into(), means, medians, path, worse, leaning, holm, finding]
        },
        helps: "有益",
        harms: "有害",
        not_shown: "未显示差别",
        too_few: "运行太少，无法检验",
    },
    tests: Tests {
        title: |title| format!("{title}：检验"),
        about: "每对参评项的双侧秩检验，没有路径的运行排在最后。W：相同种子的配对的 Wilcoxon 符号秩检验；U：Mann–Whitney 检验，种子不配对；\
                Holm 校正 p 按该地图的所有配对校正。A：前者的一次运行更好（更小）的可能性，平局算一半。",
        none: |fewest| format!("没有两个参评项各有 {fewest} 次或更多的运行，不作检验。"),
        columns: ["前者", "后者", "中位数：前者", "后者", "A", "W", "p", "Holm 校正 p", "U", "p", "Holm 校正 p"],
        over_maps: "所有地图合计",
        friedman: |maps, statistic, degrees, p| {
            format!("对 {maps} 张地图的中位数作 Friedman 检验：χ² = {statistic:.3}，自由度 {degrees}，p = {p}。")
        },
        few_maps: "地图这么少，几乎显示不出差别。",
        rank_columns: ["参评项", "平均秩"],
        differ: |[first, second, p]| format!("{first} 与 {second}（p = {p}）"),
        none_differ: "没有两个参评项显示差别",
        post_hoc: |said| format!("事后比较，Holm 校正，5%：{said}。"),
    },
    summary: Summary {
        makes_small: "优化目标",
        columns: [
            "有路径的运行",
            "最好",
            "中位数（IQR）",
            "均值 ± 标准差",
            "均值的 95% 区间",
            "中位数的差距",
            "平均差距",
            "转弯",
            "最优路径所在迭代",
        ],
        running_time: |near| format!("到 +{near} 的运行时间"),
        about: |measure, axis, target, impossible| {
            let target =
                target.map_or_else(String::new, |[what, near, value]| format!("，目标为{what}与 {value} 的差距在 {near} 以内"));
            let impossible = if impossible.is_empty() { String::new() } else { format!("；{impossible}") };
            format!(
                "{measure}只统计找到路径的运行；一次运行的差距为值 / 参照 − 1，按参评项自身的优化目标，因此差距的中位数就是中位数的差距；\
                 转弯与最优路径所在迭代为中位数；运行时间为期望，单位为{axis}{target}{impossible}"
            )
        },
        not_reached: "没有运行达到",
    },
    matrix: Matrix {
        title: |title| format!("{title}：地图 × 参评项"),
        about: "各格依次为：找到路径的运行的中位数；该中位数的差距；名次，按全部运行的中位数排列，没有路径的运行视为最长；若有运行没有\
                路径，则还有找到路径的运行比例；最后一行为所有地图的平均名次与平均差距",
        map: "地图",
        all_maps: "所有地图",
        rank: |rank| format!("名次 {rank}"),
        path_in: |share| format!("{share} 找到路径"),
        impossible: "不可能",
        not_ranked: |entries| format!("不参与排名，因为有地图上没有运行：{entries}"),
        note: |map, note| format!("{map}：{note}"),
        objectives: |map, objectives| format!("{map}：各参评项的优化目标不同，差距以各自的为准：{objectives}"),
    },
    fronts: Fronts {
        title: |title| format!("{title}：权衡"),
        about: "每次运行是一个点；若没有别的运行在每项指标上都不差且至少一项更好，它就在前沿上；相同的点算一个点，并计入每个有它的参评项；\
                超体积：在各指标最好值与参考点围成的方框中，被该参评项至少一次运行支配的部分",
        side: |measure, more| format!("{measure}（越{}越好）", if more { "大" } else { "小" }),
        measures: |measures, at| match at {
            "" => format!("{measures}：没有运行是点"),
            at => format!("{measures}；参考点：{at}"),
        },
        columns: ["", "成为点的运行", "自身前沿的点", "其中在联合前沿上（独有）", "占联合前沿的比例", "超体积"],
        alone: |joint, alone| format!("{joint}（{alone}）"),
        all: "全部参评项",
        beyond: |points, entry| format!("{entry} 的前沿有 {points} 个点并非每项指标都优于参考点，不计入超体积"),
        left_out: "其运行不作为点",
    },
    latex: Latex {
        made_by: "% !TEX program = xelatex\n% 由 ",
        needs: " 生成。\n% 需要 \\usepackage{booktabs,graphicx} 与 \\usepackage{ctex}，并以 XeLaTeX 或 LuaLaTeX 编译。\n",
        made_with: |setting| format!("Formicarium，{setting}"),
    },
};

/// How a setting begins.
const ENGINE: &str = "引擎版本 ";

fn setting([first, last]: [u32; 2], runs: RunCounts, budget: Option<Budget>) -> String {
    let RunCounts { done, alike, elsewhere } = runs;
    let alike = if alike > 0 {
        format!("（其中 {alike} 次来自无需种子的搜索，在每张地图上结果都相同）")
    } else {
        String::new()
    };
    let elsewhere = if elsewhere > 0 { format!("，另有 {elsewhere} 次外部运行") } else { String::new() };
    let budget = budget.map_or_else(String::new, |b| format!("，每次运行的预算：{} {}", axis(b.axis), b.amount));
    format!(
        "{ENGINE}{}：每个参评项在每张地图上用种子 {first} 至 {last}，共 {done} 次运行{alike}{elsewhere}{budget}。",
        env!("CARGO_PKG_VERSION")
    )
}

fn measure(measure: RunMeasure) -> &'static str {
    match measure {
        RunMeasure::Length => "路径长度",
        RunMeasure::Cost => "路径代价",
        RunMeasure::Turns => "转弯次数",
        RunMeasure::TurnIndex => "转弯指数 V",
        RunMeasure::Turning => "转角总和",
        RunMeasure::LargestCurvature => "最大曲率",
        RunMeasure::Smoothness => "平滑度",
        RunMeasure::Energy => "能耗",
        RunMeasure::ArrivalTime => "到达时间",
        RunMeasure::Weight => "权重 R",
        RunMeasure::MinClearance => "最小间距",
        RunMeasure::MeanClearance => "平均间距",
        RunMeasure::IterationOfBest => "最优路径所在迭代",
        RunMeasure::PathsToBest => "找到最优前构造的路径数",
        RunMeasure::AntMoves => "蚂蚁步数",
        RunMeasure::Success => "找到路径的运行比例",
        RunMeasure::Optimal => "达到最优的运行比例",
        RunMeasure::RunningTime => "期望运行时间",
    }
}

fn objective(objective: Objective, measure: RunMeasure) -> &'static str {
    match objective {
        Objective::Length if measure == RunMeasure::Cost => "逐格路径代价",
        Objective::PolylineLength if measure == RunMeasure::Cost => "折线代价",
        Objective::TourLength if measure == RunMeasure::Cost => "巡回代价",
        Objective::Length => "逐格路径长度",
        Objective::PolylineLength => "折线长度",
        Objective::SliceCost => "切片代价",
        Objective::TurnIndex => "转弯指数 V",
        Objective::Weighted => "加权和 J",
        Objective::TourLength => "巡回长度",
        Objective::TourWeight => "巡回权重 R",
    }
}

pub(super) fn axis(axis: Axis) -> &'static str {
    match axis {
        Axis::Iterations => "迭代次数",
        Axis::ConstructedPaths => "构造的路径数",
        Axis::AntMoves => "蚂蚁步数",
        Axis::CellExpansions => "扩展格数",
        Axis::Moves => "蚂蚁步数与扩展格数",
        Axis::Time => "秒",
    }
}

fn no_running_time(why: NoRunningTime) -> &'static str {
    match why {
        NoRunningTime::NoRuns => "未运行",
        NoRunningTime::NoTarget => "没有已知的目标",
        NoRunningTime::OtherObjective => "优化的是其他目标",
        NoRunningTime::NoIterations => "没有迭代",
        NoRunningTime::NoEffort => "工作量未知",
        NoRunningTime::Impossible => "有不可能的运行",
    }
}
