#include "simulate_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "output.hpp"

namespace graze::cli {

void print_as_json(const SummaryOf& of, const io::SimulateSummary& s) {
  Json triggers = Json::array();
  for (const io::TriggerEvent& event : s.triggers)
    triggers.push_back({{"time", event.time},
                        {"kind", event.begins ? "begin" : "end"},
                        {"trigger", of.colliders[event.trigger]},
                        {"body", of.bodies[event.body]}});
  const Json whole{
      {"scene", of.source},
      {"seconds", static_cast<double>(s.steps) / of.rate},
      {"steps", s.steps},
      {"bodies", s.bodies},
      {"joints", s.joints},
      {"awake", s.awake},
      {"milliseconds",
       {{"collide", s.collide_ms},
        {"prepare", s.prepare_ms},
        {"solve", s.solve_ms},
        {"continuous", s.continuous_ms},
        {"whole", s.whole_ms},
        {"slowest", s.slowest_ms}}},
      {"subSteps", s.most_sub_steps},
      {"deepest", {{"depth", s.deepest}, {"time", s.deepest_time}}},
      {"energy", {{"kinetic", s.kinetic_energy}, {"potential", s.potential_energy}, {"first", s.first_energy}}},
      {"triggers", triggers},
      {"notices", of.notices}};
  print(whole);
}

namespace {

/// How many bodies came into each trigger and left it, in the order in which triggers were first met.
void print_triggers(const SummaryOf& of, const io::SimulateSummary& s) {
  struct Count {
    std::uint32_t trigger;
    std::size_t in = 0, out = 0;
  };
  std::vector<Count> counts;
  for (const io::TriggerEvent& event : s.triggers) {
    auto at = std::find_if(counts.begin(), counts.end(), [&](const Count& c) { return c.trigger == event.trigger; });
    if (at == counts.end()) at = counts.insert(at, {event.trigger});
    ++(event.begins ? at->in : at->out);
  }
  for (const Count& c : counts) fmt::print("trigger   {}: {} in, {} out\n", of.colliders[c.trigger], c.in, c.out);
}

}  // namespace

void print_as_text(const SummaryOf& of, const io::SimulateSummary& s) {
  print_notes(of.notices);
  const double played = static_cast<double>(s.steps) / of.rate;
  fmt::print("{}: {} and {}, {:.6g} s in {}, computed in {:.3g} s\n\n", of.source, counted(s.bodies, "moving body"),
             counted(s.joints, "joint"), played, counted(s.steps, "step"), of.seconds);
  fmt::print(
      "a step    {:.3g} ms: collide {:.3g}, prepare {:.3g}, solve {:.3g}, continuous {:.3g}; the slowest {:.3g}; "
      "up to {}\n",
      s.whole_ms, s.collide_ms, s.prepare_ms, s.solve_ms, s.continuous_ms, s.slowest_ms,
      counted(static_cast<std::size_t>(s.most_sub_steps), "sub-step"));
  if (s.deepest > 0)
    fmt::print("deepest   {:.3g}, at {:.4g} s\n", s.deepest, s.deepest_time);
  else
    fmt::print("deepest   nothing overlapped\n");
  fmt::print("energy    {:.6g} kinetic and {:.6g} potential; at the beginning {:.6g} in all\n", s.kinetic_energy,
             s.potential_energy, s.first_energy);
  fmt::print("awake     {} of {}\n", s.awake, s.bodies);
  print_triggers(of, s);
}

}  // namespace graze::cli
