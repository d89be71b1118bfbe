#include "tools/aomd/volume_report.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

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
