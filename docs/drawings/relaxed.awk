# A relaxed pattern: 256 points on a torus that push each other away, with the force of a Gaussian as
# wide as the distance of neighbors. Writes the points to `points`, and the mean power over rings of
# ten such patterns to `power`.
BEGIN {
  srand(1)
  n = 256; sets = 10; steps = 60; kmax = 32; pi = atan2(0, -1); root = sqrt(n)
  sigma = 0.45 / root; reach = 4 * sigma
  for (set = 0; set < sets; ++set) {
    for (i = 0; i < n; ++i) { x[i] = rand(); y[i] = rand() }
    for (step = 0; step < steps; ++step) {
      for (i = 0; i < n; ++i) fx[i] = fy[i] = 0
      for (i = 0; i < n; ++i) {
        for (j = i + 1; j < n; ++j) {
          dx = x[i] - x[j]; dx -= dx > 0.5 ? 1 : dx < -0.5 ? -1 : 0
          if (dx > reach || dx < -reach) continue
          dy = y[i] - y[j]; dy -= dy > 0.5 ? 1 : dy < -0.5 ? -1 : 0
          if (dy > reach || dy < -reach) continue
          w = exp(-(dx * dx + dy * dy) / (2 * sigma * sigma))
          fx[i] += w * dx; fy[i] += w * dy; fx[j] -= w * dx; fy[j] -= w * dy
        }
      }
      for (i = 0; i < n; ++i) {
        x[i] += 0.5 * fx[i]; x[i] -= x[i] >= 1 ? 1 : x[i] < 0 ? -1 : 0
        y[i] += 0.5 * fy[i]; y[i] -= y[i] >= 1 ? 1 : y[i] < 0 ? -1 : 0
      }
    }
    if (set == 0) for (i = 0; i < n; ++i) print x[i], y[i] > points
    for (kx = 0; kx <= kmax; ++kx) {
      for (ky = -kmax; ky <= kmax; ++ky) {
        ring = int(sqrt(kx * kx + ky * ky) + 0.5)
        if (ring == 0 || ring > kmax) continue
        re = im = 0
        for (i = 0; i < n; ++i) {
          a = 2 * pi * (kx * x[i] + ky * y[i]); re += cos(a); im += sin(a)
        }
        sum[ring] += (re * re + im * im) / n; ++many[ring]
      }
    }
  }
  for (ring = 1; ring <= kmax; ++ring) print ring / root, sum[ring] / many[ring] > power
}
