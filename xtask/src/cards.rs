//! The tables that a paper's card takes over from a record, in both languages: what the card says of a claim is what came out.
//!
//! A place for one begins with `<!-- From records/NAME.md: HEADING -->` and ends with `<!-- End -->`.

mod orders;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, anyhow, bail};

use crate::tools::root;

const BEGIN: &str = "<!-- From records/";
const END: &str = "<!-- End -->";

/// Writes the tables of every card anew, and draws the one figure that is ours to draw.
pub fn update() -> Result<()> {
    orders::draw()?;
    let chinese = Chinese::read()?;
    for folder in ["docs/papers", "docs/zh/papers"] {
        let is_chinese = folder.contains("/zh/");
        for card in root().join(folder).read_dir()? {
            let card = card?.path();
            let text = fs::read_to_string(&card)?;
            let made = filled(&text, |table| if is_chinese { chinese.table(table) } else { Ok(table.into()) });
            let made = made.with_context(|| format!("in {}", card.display()))?;
            if made != text {
                fs::write(&card, made)?;
            }
        }
    }
    Ok(())
}

/// A card with its tables as the records have them.
fn filled(card: &str, told: impl Fn(&str) -> Result<String>) -> Result<String> {
    let mut parts = card.split(BEGIN);
    let mut made = parts.next().unwrap_or_default().to_string();
    for part in parts {
        let (from, rest) = part.split_once(" -->\n").ok_or_else(|| anyhow!("a place for a table that names none"))?;
        let (_, rest) = rest.split_once(END).ok_or_else(|| anyhow!("no {END} after the place for {from}"))?;
        let (record, heading) = from.split_once(": ").ok_or_else(|| anyhow!("{from} names no heading"))?;
        let record = fs::read_to_string(root().join("experiments/records").join(record))?;
        made += &format!("{BEGIN}{from} -->\n\n{}\n{END}{rest}", told(&table(&record, heading)?)?);
    }
    Ok(made)
}

/// The lines of the table below a heading.
fn table(record: &str, heading: &str) -> Result<String> {
    let (_, below) = record.split_once(&format!("\n## {heading}\n\n")).ok_or_else(|| anyhow!("no heading {heading}"))?;
    Ok(below.lines().take_while(|line| line.starts_with('|')).map(|line| format!("{line}\n")).collect())
}

/// Verdicts, counts and heads in the words of the Chinese reports (src/comparison/report/words/claims/zh_cn.rs); the longer ones first.
const WORDS: [(&str, &str); 32] = [
    ("**direction reproduced**, size cannot be told", "**方向已复现**，大小无法判断"),
    ("**partly**: less than half of the size", "**部分复现**：不到所称大小的一半"),
    ("**reproduced** (no size is claimed)", "**已复现**（没有所称的大小）"),
    ("**reproduced**", "**已复现**"),
    ("**no relevant difference**", "**无实质差别**"),
    ("**no difference shown**", "**未显示差别**"),
    ("**the opposite**", "**结果相反**"),
    ("**depends on the map**", "**取决于地图**"),
    ("**cannot tell**: fewer than 6 maps", "**无法判断**：地图少于 6 张"),
    ("**cannot tell**", "**无法判断**"),
    ("no relevant difference", "无实质差别"),
    ("no difference shown", "未显示差别"),
    ("cannot tell", "无法判断"),
    ("reproduced", "已复现"),
    ("direction", "方向已复现"),
    ("partly", "部分复现"),
    ("opposite", "结果相反"),
    ("as printed", "按印刷公式"),
    ("as we read it", "按我们的理解"),
    ("second reading", "第二种读法"),
    ("expected running time to within 5 %, constructed paths", "达到 5% 以内的期望运行时间，构造的路径数"),
    ("share of runs with a path", "找到路径的运行比例"),
    ("constructed paths to best", "找到最优前构造的路径数"),
    ("iteration of best", "最优路径所在迭代"),
    ("weight R", "权重 R"),
    ("verdict over maps", "所有地图的判定"),
    ("median effect [95 %]", "效应的中位数 [95%]"),
    ("signs + / 0 / −, p", "符号 + / 0 / −，p"),
    ("better on", "更好的地图"),
    ("by map", "各地图的判定"),
    ("points", "个百分点"),
    (" %", "%"),
];

/// Whole cells.
const CELLS: [(&str, &str); 6] = [
    ("claim", "主张"),
    ("measure", "衡量标准"),
    ("length", "路径长度"),
    ("turns", "转弯次数"),
    ("cost", "路径代价"),
    ("arrival time", "到达时间"),
];

/// Prints a dictionary of the page as JSON; the page's own tool reads TypeScript.
const AS_JSON: &str = "\
import { runnerImport } from 'vite'
const { module } = await runnerImport(process.argv[1], { configFile: false, logLevel: 'error' })
console.log(JSON.stringify(module.zhCNQuestions))";

/// What the page says in Chinese of the questions' own texts.
struct Chinese(BTreeMap<String, String>);

impl Chinese {
    fn read() -> Result<Self> {
        let from = root().join("www/src/i18n/zh_cn/questions.ts");
        let node = Command::new("node")
            .current_dir(root().join("www"))
            .args(["--input-type=module", "--eval", AS_JSON])
            .arg(&from)
            .output();
        let told = node.context("cannot run node")?;
        if !told.status.success() {
            bail!("{}: {}", from.display(), String::from_utf8_lossy(&told.stderr));
        }
        Ok(Self(serde_json::from_slice(&told.stdout)?))
    }

    fn table(&self, english: &str) -> Result<String> {
        english.lines().map(|line| Ok(format!("{}\n", self.row(line)?))).collect()
    }

    fn row(&self, english: &str) -> Result<String> {
        let inner = english.trim_start_matches("| ").trim_end_matches(" |");
        if english.starts_with("|---") {
            return Ok(english.into());
        }
        let mut cells: Vec<String> = Vec::new();
        for (place, cell) in inner.split(" | ").enumerate() {
            let whole = CELLS.iter().find(|(english, _)| *english == cell).map(|(_, chinese)| chinese.to_string());
            cells.push(match whole {
                Some(whole) => whole,
                None if place == 0 => self.said(cell)?,
                None => in_words(cell),
            });
        }
        Ok(format!("| {} |", cells.join(" | ")))
    }

    /// A claim, or a claim with its two entries.
    fn said(&self, english: &str) -> Result<String> {
        let known = |text: &str| self.0.get(text).cloned();
        if let Some(whole) = known(english) {
            return Ok(whole);
        }
        let ends = |(at, _): (usize, &str)| (&english[..at], &english[at + 2..]);
        let split = english.match_indices(": ").map(ends).find_map(|(says, entries)| {
            let both = |(at, _): (usize, &str)| Some((known(&entries[..at])?, known(&entries[at + " against ".len()..])?));
            let (improved, baseline) = entries.match_indices(" against ").find_map(both)?;
            Some(format!("{}：“{improved}”对比“{baseline}”", known(says)?))
        });
        split.ok_or_else(|| anyhow!("{english} has no Chinese in {}", Path::new("www/src/i18n/zh_cn/questions.ts").display()))
    }
}

/// Verdicts and numbers: `3 of 5 maps` is turned round, the rest word by word.
fn in_words(english: &str) -> String {
    let mut text = english.replace("; ", "；");
    for (english, chinese) in WORDS {
        text = text.replace(english, chinese);
    }
    let parts = text.split('；').map(|part| match part.split_once(" maps") {
        Some((of, rest)) => match of.split_once(" of ") {
            Some((some, all)) => format!("{all} 张地图中的 {some} 张{rest}"),
            None => part.into(),
        },
        None => part.to_string(),
    });
    with_commas(&parts.collect::<Vec<_>>().join("；"))
}

/// Commas between words are those of Chinese; those of intervals stay.
fn with_commas(text: &str) -> String {
    let outside = |(place, part): (usize, &str)| match (place, part.split_once(']')) {
        (0, _) => part.replace(", ", "，"),
        (_, Some((interval, rest))) => format!("[{interval}]{}", rest.replace(", ", "，")),
        (_, None) => format!("[{part}"),
    };
    text.split('[').enumerate().map(outside).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chinese() -> Chinese {
        Chinese(
            [("shorter paths", "路径更短"), ("ACO", "ACO"), ("ACO, as printed", "ACO，按印刷公式")]
                .map(|(a, b)| (a.into(), b.into()))
                .into(),
        )
    }

    #[test]
    fn a_row_is_told_in_chinese() {
        let told = chinese().row("| shorter paths | length | **reproduced**; 3 of 5 maps; −1.5 % [−2.0, +1.0] | – |").unwrap();
        assert_eq!(told, "| 路径更短 | 路径长度 | **已复现**；5 张地图中的 3 张；−1.5% [−2.0, +1.0] | – |");
        let told = chinese().row("| shorter paths: ACO, as printed against ACO | 1 of 2 maps [9 %, 91 %] |").unwrap();
        assert_eq!(told, "| 路径更短：“ACO，按印刷公式”对比“ACO” | 2 张地图中的 1 张 [9%, 91%] |");
        assert_eq!(in_words("2 reproduced, 1 opposite [1.0, 2.0], p = 0.5"), "2 已复现，1 结果相反 [1.0, 2.0]，p = 0.5");
        assert!(chinese().row("| longer paths | length |").is_err());
    }

    #[test]
    fn a_place_takes_the_lines_below_its_heading() {
        let record = "# A\n\n## Claims\n\n| a |\n|---|\n| b |\n\n## More\n\n| c |\n";
        assert_eq!(table(record, "Claims").unwrap(), "| a |\n|---|\n| b |\n");
        assert!(table(record, "None").is_err());
    }
}
