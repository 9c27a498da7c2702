# Prints the settings that every colony tries: its own values and 20 points of Richtmyer's sequence, the fractional parts of i·√2, i·√3, i·√5
# and so on; each of them with an end by the budget alone, and with 100 iterations (of its own values, as many as it has).
function part(i, prime, x) { x = i * sqrt(prime); return x - int(x) }
function log_between(low, high, u) { return low * exp(u * log(high / low)) }
BEGIN {
    print "setting,ants,alpha,beta,rho,dead_end,move_limit,iterations"
    print "own,,,,,,,"
    print "own-unending,,,,,,,100000"
    for (i = 1; i <= 20; i++) {
        ants = int(log_between(4, 64, part(i, 2)) + 0.5)
        alpha = 0.5 + 2.5 * part(i, 3)
        beta = log_between(1, 20, part(i, 5))
        rho = log_between(0.02, 0.8, part(i, 7))
        dead_end = part(i, 11) < 0.5 ? "backtrack" : "die"
        move_limit = part(i, 13) < 0.5 ? 4 : 16
        point = sprintf("%d,%.3g,%.3g,%.3g,%s,%d", ants, alpha, beta, rho, dead_end, move_limit)
        printf "s%02d-unending,%s,100000\ns%02d,%s,100\n", i, point, i, point
    }
}
