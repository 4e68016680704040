# Words in formulas, and how formulas are spoken.

formula-hit = hit
formula-miss = miss
formula-touch = touch
formula-skip = skip
formula-go-on = go on
formula-end = leave
formula-near-half = near half
formula-far-half = far half
formula-both-halves = both halves
formula-no-cell = no cell
formula-reversed = reversed
formula-leftmost = leftmost digit
formula-rightmost = rightmost digit
formula-axes-crossed = crossed axes
formula-axes-mirrored = axes of s

sign-equal = equals
sign-about = is about
sign-unequal = is not equal to
sign-less = is less than
sign-less-or-equal = is at most
sign-greater = is greater than
sign-greater-or-equal = is at least
sign-in = lies in
sign-not-in = does not lie in
sign-implies = , so
sign-takes = becomes
sign-plus = plus
sign-minus = minus
sign-times = times
sign-xor = xor
sign-and = and
sign-or = or
sign-shift = shifted right by
sign-not = not
sign-comma = ,
sign-to = to

spoken-fraction = { $over } over { $under }
spoken-power = { $body } to the power of { $above }
spoken-prime = { $body } prime
spoken-over = { $operator } over { $limit } of
spoken-round = ({ $body })
spoken-floor = floor of ({ $body })
spoken-ceiling = ceiling of ({ $body })
spoken-absolute = absolute value of ({ $body })
