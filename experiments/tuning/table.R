# Prints the table of README.md: values of preset and tuning, and their means on training maps and on those of the records.
# usage: Rscript experiments/tuning/table.R
here <- dirname(sub("--file=", "", grep("--file=", commandArgs(), value = TRUE)))
setwd(here)
training <- read.csv("training.csv")
measures <- c(ship = "length", threshold = "length", fireworks = "length", fire = "weight", terrain = "value")

# Mean over the runs with a path, and in how many there was none.
shown <- function(mean, runs, found) {
  lost <- if (found < runs) sprintf(" (%.1f %% without a path)", 100 * (1 - found / runs)) else ""
  if (found == 0) "no path" else paste0(format(round(mean, 2), nsmall = 2), lost)
}

trained <- function(name, setting) {
  row <- training[training$name == name & training$setting == setting, ]
  shown(row$mean, row$runs, row$found)
}

held_out <- function(name, setting) {
  question <- sub("-.*", "", name)
  record <- read.csv(file.path("records", paste0(question, ".csv")))
  entry <- paste0(sub("[a-z]*-", "", name), if (setting == "tuned") "-tuned" else "")
  values <- record[record$entry == entry, measures[[question]]]
  shown(mean(values, na.rm = TRUE), length(values), sum(!is.na(values)))
}

values <- function(name) {
  presets <- read.table(file.path("parameters", paste0(name, ".default.txt")), header = TRUE)
  set <- sub("set = \\{ (.*) \\}", "\\1", grep("^set", readLines(file.path("tuned", paste0(name, ".toml"))), value = TRUE))
  tuned <- sapply(strsplit(strsplit(set, ", ")[[1]], " = "), function(pair) pair[2])
  paste(sprintf("`%s` %s → %s", names(presets), format(signif(unlist(presets), 3), trim = TRUE, drop0trailing = TRUE), tuned), collapse = ", ")
}

cat("| | preset → tuned | training maps: preset | tuned | held-out maps: preset | tuned |\n|---|---|---|---|---|---|\n")
for (name in unique(training$name)) {
  cells <- c(name, values(name), trained(name, "preset"), trained(name, "tuned"), held_out(name, "preset"), held_out(name, "tuned"))
  cat("|", paste(cells, collapse = " | "), "|\n")
}

# Which way a verdict tells of a claim.
side <- function(verdict) {
  if (grepl("^reproduced|^direction|^partly", verdict)) "for" else if (grepl("opposite", verdict)) "against" else if (grepl("^cannot", verdict)) "untold" else "neither"
}

# The claims over maps of a record, in pairs: with the preset's values, and the same with tuned ones.
verdicts <- function(question) {
  lines <- readLines(file.path("records", paste0(question, ".md")))
  lines <- lines[grep("^## Claims", lines):grep("^### Map by map", lines)]
  rows <- strsplit(grep("^\\|.*\\*\\*", lines, value = TRUE), " *\\| *")
  told <- function(row) c(sub(".*\\*\\*(.*)\\*\\*.*", "\\1", row[7]), paste0(sub("cannot tell.*", "–", row[6]), "; ", sub(" maps.*", "", row[3])))
  lapply(seq(1, length(rows), 2), function(first) {
    preset <- told(rows[[first]])
    tuned <- told(rows[[first + 1]])
    sides <- c(side(preset[1]), side(tuned[1]))
    flips <- if (preset[1] == tuned[1]) "" else if (sides[1] == sides[2]) "changes" else if ("untold" %in% sides) "told by one alone" else "**flips**"
    c(question, rows[[first]][2], preset, tuned, flips)
  })
}

cat("\n| | claim | preset: verdict over maps | effect; better on | tuned: verdict over maps | effect; better on | |\n|---|---|---|---|---|---|---|\n")
for (row in unlist(lapply(names(measures), verdicts), recursive = FALSE)) cat("|", paste(row, collapse = " | "), "|\n")
