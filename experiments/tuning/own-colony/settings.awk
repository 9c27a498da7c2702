# Prints the settings that every colony tries: its own values, the same without an end by iterations, and 40 points of Richtmyer's sequence,
# the fractional parts of i·√2, i·√3, i·√5 and so on.
function part(i, prime, x) { x = i * sqrt(prime); return x - int(x) }
function log_between(low, high, u) { return low * exp(u * log(high / low)) }
BEGIN {
    print "setting,ants,alpha,beta,rho,dead_end,move_limit,iterations"
    print "own,,,,,,,"
    print "own-unending,,,,,,,100000"
    for (i = 1; i <= 40; i++) {
        ants = int(log_between(4, 64, part(i, 2)) + 0.5)
        alpha = 0.5 + 2.5 * part(i, 3)
        beta = log_between(1, 20, part(i, 5))
        rho = log_between(0.02, 0.8, part(i, 7))
        dead_end = part(i, 11) < 0.5 ? "backtrack" : "die"
        move_limit = part(i, 13) < 0.5 ? 4 : 16
        third = int(3 * part(i, 17))
        iterations = third == 0 ? 100 : third == 1 ? 1000 : 100000
        printf "s%02d,%d,%.3g,%.3g,%.3g,%s,%d,%d\n", i, ants, alpha, beta, rho, dead_end, move_limit, iterations
    }
}
