#include "tools/aomd/volume_report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>

#include "core/base/text.h"
#include "core/mesh/names.h"

namespace aomd::cli {
namespace {

constexpr std::size_t most_lines = 20;

double volume_of(const measure::VolumeComplex& complex) {
  double sum = 0;
  for (const measure::RegionFacts& facts : complex.regions) sum += facts.volume;
  return sum;
}

Json facts_json(const measure::RegionFacts& facts) {
  return {{"tag", region_json(facts.model)},
          {"regions", facts.regions},
          {"volume", facts.volume},
          {"euler", facts.euler},
          {"parts", facts.parts}};
}

Json shape_json(const measure::VolumeQuality& quality) {
  if (quality.tetrahedra == 0) return nullptr;
  return {{"min", quality.shape_min}, {"mean", quality.shape_mean}};
}

}  // namespace

std::string region_name(ModelRef model) {
  return model.valid() ? std::to_string(model.tag()) : "none";
}

Json region_json(ModelRef model) { return model.valid() ? Json(model.tag()) : Json(nullptr); }

Json volume_json(const measure::VolumeComplex& complex, const measure::VolumeQuality& quality) {
  Json list = Json::array();
  for (const measure::RegionFacts& facts : complex.regions) list.push_back(facts_json(facts));
  return {{"volume", volume_of(complex)},
          {"model_regions", list},
          {"inverted", quality.inverted.size()},
          {"repeated", complex.repeated.size()},
          {"folded", complex.folded.size()},
          {"nonconforming", complex.crowded.size()},
          {"dangling_faces", complex.dangling_faces},
          {"dihedral",
           {{"min_deg", quality.min_dihedral_deg},
            {"p5_deg", quality.p5_dihedral_deg},
            {"mean_deg", quality.mean_dihedral_deg},
            {"below_10deg_pct", quality.regions_below_10deg_pct}}},
          {"shape", shape_json(quality)}};
}

double VolumeChange::percent() const {
  const double by = volume[1] - volume[0];
  if (by == 0) return 0;
  return volume[0] > 0 ? 100 * by / volume[0] : std::numeric_limits<double>::infinity();
}

std::vector<VolumeChange> volume_changes(const std::vector<measure::RegionVolume>& before,
                                         const std::vector<measure::RegionVolume>& after) {
  std::map<ModelRef, VolumeChange> changes;
  std::size_t side = 0;
  for (const auto* list : {&before, &after}) {
    for (const measure::RegionVolume& r : *list) {
      VolumeChange& change = changes[r.model];
      change.model = r.model;
      change.regions[side] = r.regions;
      change.volume[side] = r.volume;
    }
    ++side;
  }
  std::vector<VolumeChange> all;
  all.reserve(changes.size());
  for (const auto& [model, change] : changes) all.push_back(change);
  return all;
}

double largest_percent(const std::vector<VolumeChange>& changes) {
  double largest = 0;
  for (const VolumeChange& change : changes)
    if (std::abs(change.percent()) > std::abs(largest)) largest = change.percent();
  return largest;
}

Json volume_changes_json(const std::vector<VolumeChange>& changes) {
  Json list = Json::array();
  for (const VolumeChange& change : changes)
    list.push_back({{"tag", region_json(change.model)},
                    {"regions", change.regions},
                    {"volume", change.volume},
                    {"volume_change_pct", change.percent()}});
  return list;
}

void print_volume_changes(std::ostream& out, const std::vector<VolumeChange>& changes) {
  const auto line = [&out](const auto&... values) {
    out << "  ";
    ((out << std::setw(14) << values), ...) << '\n';
  };
  out << std::right << std::defaultfloat << std::setprecision(6);
  line("model region", "volume", "now", "change, %");
  const std::size_t shown = std::min(changes.size(), most_lines);
  for (std::size_t i = 0; i < shown; ++i) {
    const VolumeChange& change = changes[i];
    line(region_name(change.model), change.volume[0], change.volume[1],
         number_text(change.percent(), 2));
  }
  if (shown < changes.size())
    out << "  and " << changes.size() - shown << " more; --report has all\n";
}

void print_regions(const measure::VolumeComplex& complex) {
  const auto line = [](const auto&... values) {
    std::cout << "  ";
    ((std::cout << std::setw(14) << values), ...) << '\n';
  };
  std::cout << std::right << std::defaultfloat << std::setprecision(6);
  line("model region", "regions", "volume", "Euler number", "parts");
  const std::size_t shown = std::min(complex.regions.size(), most_lines);
  for (std::size_t i = 0; i < shown; ++i) {
    const measure::RegionFacts& facts = complex.regions[i];
    line(region_name(facts.model), facts.regions, facts.volume, facts.euler, facts.parts);
  }
  if (shown < complex.regions.size())
    std::cout << "  and " << complex.regions.size() - shown << " more; --json has all\n";
  if (shown > 1) line("all", "", volume_of(complex), "", "");
}

std::vector<Finding> volume_findings(const measure::VolumeComplex& complex,
                                     const measure::VolumeQuality& quality) {
  std::vector<Finding> findings;
  for (const Region r : quality.inverted)
    findings.push_back({"inverted region", r, "its volume is zero or negative"});
  for (const auto& [a, b] : complex.folded)
    findings.push_back(
        {"folded region", b, "lies on the same side as " + name_of(a) + " of a face of both"});
  for (const Region r : complex.crowded)
    findings.push_back({"crowded face", r, "has a face that two more regions have"});
  return findings;
}

}  // namespace aomd::cli
