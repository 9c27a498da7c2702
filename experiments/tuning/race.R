# One race of irace, and its best values, three significant digits each, as an entry of a question writes them: tuned/NAME.toml.
# tune.sh starts it: Rscript race.R NAME GROUP
library(irace)
name <- commandArgs(TRUE)[1]
group <- commandArgs(TRUE)[2]
work <- Sys.getenv("WORK")
log <- file.path(work, paste0(name, ".Rdata"))
irace.cmdline(c(
  "--scenario", "scenario.txt",
  "--parameter-file", file.path("parameters", paste0(name, ".txt")),
  "--configurations-file", file.path("parameters", paste0(name, ".default.txt")),
  "--train-instances-file", file.path(work, "maps", paste0(group, ".txt")),
  "--log-file", log
))
best <- getFinalElites(log, n = 1, drop.metadata = TRUE)
set <- paste(names(best), "=", format(signif(unlist(best), 3), scientific = FALSE, drop0trailing = TRUE, trim = TRUE), collapse = ", ")
options <- strsplit(trimws(Sys.getenv("TUNED")), " +")[[1]]
lines <- sprintf('%s = "%s"', sub("--", "", options[c(TRUE, FALSE)]), options[c(FALSE, TRUE)])
dir.create("tuned", showWarnings = FALSE)
writeLines(c(lines, sprintf("set = { %s }", set)), file.path("tuned", paste0(name, ".toml")))
