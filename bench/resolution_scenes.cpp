#include "resolution_scenes.hpp"

#include "resolution_measures.hpp"

namespace graze::bench {

std::vector<ResolutionRow> resolution_rows(bool long_ones) {
  using K = const EngineKind&;
  std::vector<ResolutionRow> rows;
  if (long_ones)
    rows.push_back(
        {"a tallest tower that stands for 20 s (10 to 100)", "100", "40", "10", [](K k) { return tallest(k, false); }});
  if (long_ones) rows.push_back({"a the same, sleep on", "100", "40", "10", [](K k) { return tallest(k, true); }});
  const auto measured = [&](const char* what, const char* target, const char* box3d, const char* jolt, auto measure) {
    rows.push_back({what, target, box3d, jolt, measure});
  };
  measured("a 10 boxes: the top's sink, drift; energy", "20 mm, 5 mm, 1e-3 J", "26 mm, 0.2 mm", "15 mm, 51 mm",
           [](K k) { return tower_row(k, 10, 0); });
  measured("a 40 boxes", "20 mm, 5 mm, 1e-3 J", "442 mm, 5 mm", "falls", [](K k) { return tower_row(k, 40, 0); });
  measured("a 40 boxes, each off by ± 2 cm", "stands", "336 mm drift", "falls",
           [](K k) { return tower_row(k, 40, 0.02); });
  measured("a 60 boxes, each off by ± 2 cm", "stands", "-", "-", [](K k) { return tower_row(k, 60, 0.02); });
  measured("b pyramid, base 20: deepest, drift, energy, time a step", "1 mm, 3 mm, 1e-5 J, 0.3 ms",
           "3.3 mm, 11 mm, 8e-6 J, 0.55 ms", "6.8 mm, 30 mm, 3.5 J, 0.75 ms", pyramid);
  measured("c 10 times the mass on one box: deepest; energy", "1 mm", "3.1 mm", "2.8 mm",
           [](K k) { return heavy_on_light(k, 10, 1); });
  measured("c 100 times", "3 mm", "28 mm", "29 mm", [](K k) { return heavy_on_light(k, 100, 1); });
  measured("c 100 times, on five boxes", "10 mm", "79 mm", "falls", [](K k) { return heavy_on_light(k, 100, 5); });
  measured("c 1000 times", "20 mm", "355 mm", "falls", [](K k) { return heavy_on_light(k, 1000, 1); });
  measured("d slope of 30°, friction 1.02 tan: creep in 2 s, after 0.2 s, cube", "0.1 mm, 0", "1.4 mm", "0.04 mm",
           [](K k) { return creep(k, false); });
  measured("d the same, plate", "0.1 mm, 0", "0.1 mm", "0 mm", [](K k) { return creep(k, true); });
  measured("d friction 0.98 tan: speed / exact, cube", "1 ± 0.005", "1.080", "1.002",
           [](K k) { return sliding(k, 0.98, false, false); });
  measured("d the same, plate", "1 ± 0.005", "1.003", "1.000", [](K k) { return sliding(k, 0.98, true, false); });
  measured("d friction 0.5 tan: way / exact, plate", "1 ± 0.005", "1.003", "1.008",
           [](K k) { return sliding(k, 0.5, true, true); });
  measured("d 10 m/s, friction 0.5: stops after (10 m)", "10 ± 0.01 m", "9.82 to 9.98 m", "9.82 to 9.98 m", stopping);
  measured("e restitution 0.5, ball from 5 m: rebound / exact", "1 ± 0.005", "0.980", "0.967", rebound);
  measured("e restitution 1, ball: energy after 20 s", "1 ± 0.002", "0.984", "1.003",
           [](K k) { return elastic(k, true); });
  measured("e the same, box that falls flat", "1 ± 0.002", "0", "1.003", [](K k) { return elastic(k, false); });
  measured("e Newton's cradle, 5 m/s: the last ball, the fastest other; energy", "5 ± 0.01, 0.01 m/s, 1",
           "1.70 m/s, -, 0.67", "1.66 m/s, -, 0.93", cradle);
  measured("f free spin, 10 rad/s, 20 s: momentum, its turn, energy; flips", "1e-6, 1e-4°, 1e-4, 9", "-24 %, -, -42 %",
           "+0.01 %, 26°, +0.03 %", [](K k) { return spin(k, 10); });
  measured("f 30 rad/s", "1e-6, 1e-4°, 1e-3, 28", "-71 %, -, -92 %", "+0.01 %, 38°, 0.03 %",
           [](K k) { return spin(k, 30); });
  measured("free fall of 1 s (5 m)", "5 m to rounding", "-", "-", free_fall);
  measured("g card house of 40 cards: fallen, greatest move", "0, 20 mm", "0, 36 mm", "0, 57 mm", card_house);
  if (long_ones)
    measured("h 5,000 boxes fall into a bin, 480 steps: time a step, deepest, energy after 360, 480",
             "half of Bullet's, 20 mm, falling", "23-25 ms, 199 mm, -, 0.05 J", "28-31 ms, 37 mm, -, 5e3 J", pile);
  if (long_ones) measured("h the same, after 120 steps: times as fast on two threads", "1.6", "-", "-", two_threads);
  if (long_ones)
    measured("h 5,000 boxes at rest, started cold: time of a step, median of 60, deepest", "half of Bullet's, 20 mm",
             "35-38 ms", "44-50 ms", settled_pile);
  measured("i 30 cylinders, sleep on: asleep, since, deepest", "30, 5 s, 1 mm", "30", "30", cylinders);
  measured("i 20 balls in a bowl of triangles, sleep on: the same", "20, 5 s, 1 mm", "20, -, 0", "20, -, 4.6 mm",
           balls_in_bowl);
  measured("j box of 0.2 m, 300 m/s, wall of 1 cm: through, of 100", "0", "0", "0",
           [](K k) { return through_wall(k, 0.2, false); });
  measured("j box of 1 m", "0", "0", "0", [](K k) { return through_wall(k, 1, false); });
  measured("j box of 0.2 m, a wall that moves", "0", "-", "-", [](K k) { return through_wall(k, 0.2, true); });
  measured("j rod of 4 m past a post, 10 rad/s: unnoticed, of 100", "0", "0", "69",
           [](K k) { return past_post(k, 10, false); });
  measured("j 40 rad/s", "0", "0", "92", [](K k) { return past_post(k, 40, false); });
  measured("j 10 rad/s, a post that moves", "0", "-", "-", [](K k) { return past_post(k, 10, true); });
  measured("j 40 rad/s, a post that moves", "0", "-", "-", [](K k) { return past_post(k, 40, true); });
  measured("k the same bits: twice; on 1, 2, 4 and 8 threads; after restoring", "yes; yes; yes", "yes; yes; -",
           "yes; yes; -", same_bits);
  measured("l five boxes of 1 mm / 1 cm / 10 cm / 1 m / 100 m: sink of a size", "from 1 cm up",
           "odd / no / 6 % / 0.6 % / 0", "no / no / 2.4 % / 0.2 % / 0", sizes);
  measured("m 600 pairs meet at 10 m/s: change of momentum, of angular momentum at most, mean", "rounding", "-", "-",
           [](K k) { return meeting(k, 0, 0); });
  measured("m the same, friction 0.6", "rounding", "-", "-", [](K k) { return meeting(k, 0, 0.6); });
  measured("m the same, restitution 0.5", "rounding", "-", "-", [](K k) { return meeting(k, 0.5, 0); });
  measured("m the same, friction 0.6, restitution 0.5", "rounding", "-", "-", [](K k) { return meeting(k, 0.5, 0.6); });
  return rows;
}

}  // namespace graze::bench
