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
