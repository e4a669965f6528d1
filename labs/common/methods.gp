# The style (common/draw.gp) of each method of making points: one colour and mark in every plot of
# the course. Lines that are none (integrands, ways to a variance) take 1, 2, 3, ...
independent = 1
jittered = 2
halton = 3
multi_jittered = 4
sobol = 5
scrambled_sobol = 6
latin_hypercube = 7
hammersley = 8
best_candidate = 10
few_candidates = 11
poisson_disk = 12
padded = 13
rotated = 14
digits_permuted = 15
