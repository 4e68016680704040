# Wörter in Formeln und wie Formeln gesprochen werden.

formula-hit = Treffer
formula-miss = kein Treffer
formula-touch = Berührung
formula-skip = überspringen
formula-go-on = weiter
formula-end = verlassen
formula-near-half = nahe Hälfte
formula-far-half = ferne Hälfte
formula-both-halves = beide Hälften
formula-no-cell = keine Zelle
formula-reversed = umgekehrt
formula-leftmost = linke Stelle
formula-rightmost = rechte Stelle
formula-axes-crossed = gekreuzte Achsen
formula-axes-mirrored = Achsen von s

sign-equal = gleich
sign-about = ungefähr
sign-unequal = ungleich
sign-less = kleiner als
sign-less-or-equal = höchstens
sign-greater = größer als
sign-greater-or-equal = mindestens
sign-in = liegt in
sign-not-in = liegt nicht in
sign-implies = , also
sign-takes = wird
sign-plus = plus
sign-minus = minus
sign-times = mal
sign-xor = xor
sign-and = und
sign-or = oder
sign-shift = nach rechts verschoben um
sign-not = nicht
sign-comma = ,
sign-to = bis

spoken-fraction = { $over } durch { $under }
spoken-power = { $body } hoch { $above }
spoken-prime = { $body } Strich
spoken-over = { $operator } über { $limit } von
spoken-round = ({ $body })
spoken-floor = abgerundet ({ $body })
spoken-ceiling = aufgerundet ({ $body })
spoken-absolute = Betrag von ({ $body })
