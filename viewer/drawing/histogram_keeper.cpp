#include "viewer/drawing/histogram_keeper.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include <glm/geometric.hpp>

#include "core/measure/volume_statistics.h"
#include "viewer/document/beside_mesh.h"

namespace aomd::scene {
namespace {

using measure::Histogram;
using measure::make_histogram;
using measure::Sample;

constexpr double shown_share = 0.99;     // of the lengths; the rest counts in the last bin
constexpr double least_length_span = 2;  // of lengths, so that 1 is well inside

/// A whole number that nearly all values lie below.
double span_of(std::span<const Sample> samples) {
  if (samples.empty()) return least_length_span;
  std::vector<double> values;
  for (const Sample& sample : samples) values.push_back(sample.value);
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(shown_share * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return std::max(least_length_span, std::ceil(*at));
}

void count(HistogramKind kind, bool volume, HistogramPair& pair) {
  double low = 0, high = volume ? 90 : 60;
  std::size_t bins = 30;
  if (kind == HistogramKind::Length) high = std::max(span_of(pair.samples), span_of(pair.earlier));
  if (kind == HistogramKind::Valence) low = 2, high = 13, bins = 11;
  pair.before = make_histogram(pair.earlier, low, high, bins);
  pair.now = make_histogram(pair.samples, low, high, bins);
}

bool some_wanted(const Mesh& mesh, const Column<Vertex, double>& wanted) {
  for (const Vertex v : mesh.vertices())
    if (v.index < wanted.size() && wanted[v] > 0 && std::isfinite(wanted[v])) return true;
  return false;
}

double mean_length(const Mesh& mesh) {
  double sum = 0;
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    sum += glm::length(mesh.position(b) - mesh.position(a));
  }
  return mesh.count(1) > 0 ? sum / mesh.count(1) : 0;
}

std::vector<Sample> samples_of(HistogramKind kind, const Mesh& mesh,
                               const Column<Vertex, double>& lengths) {
  const bool volume = mesh.count(3) > 0;
  if (kind == HistogramKind::Angle)
    return volume ? measure::smallest_dihedrals(mesh) : measure::smallest_angles(mesh);
  if (volume) return {};
  return kind == HistogramKind::Length ? measure::length_ratios(mesh, lengths)
                                       : measure::valences(mesh);
}

/// Sorted by what they are.
std::vector<RegionContent> region_contents(const Mesh& mesh) {
  std::map<ModelRef, RegionContent> regions;
  for (const Region r : mesh.regions()) {
    RegionContent& content = regions[mesh.classification(r)];
    ++content.count;
    // Whichever way files number them.
    content.volume += std::abs(measure::signed_volume(mesh, r));
  }
  std::vector<RegionContent> contents;
  for (auto& [model, content] : regions) {
    content.model = model;
    contents.push_back(content);
  }
  return contents;
}

/// Those of both, side by side.
std::vector<RegionChange> side_by_side(const std::vector<RegionContent>& now,
                                       const std::vector<RegionContent>& before) {
  std::map<ModelRef, RegionChange> both;
  for (const RegionContent& each : before) both[each.model] = {{each.model, 0, 0}, each};
  for (const RegionContent& each : now) both[each.model].now = each;
  std::vector<RegionChange> changes;
  changes.reserve(both.size());
  for (const auto& [model, change] : both) changes.push_back(change);
  return changes;
}

constexpr std::array kinds = {HistogramKind::Angle, HistogramKind::Length, HistogramKind::Valence};

}  // namespace

bool HistogramKeeper::update(Document& document, const KeptRun* reference, bool wanted,
                             bool still) {
  if (!wanted || document.empty()) {
    const bool had = histograms_.has_value();
    histograms_.reset();
    return had;
  }
  const HistoryPlace place = document.place();
  const unsigned number = reference == nullptr ? 0 : reference->number;
  const std::uint64_t options = document.options_revision();
  const bool reset = !histograms_ || number != reference_ || options_ != options;
  if (!reset && place == place_) return false;
  if (!still) return false;
  if (reset) {
    options_ = options;
    histograms_.emplace();
    histograms_->volume = document.content().volume();
    measure_before(document, reference);
  }
  place_ = place;
  reference_ = number;
  histograms_->changed = place.cursor > 0 || reference != nullptr;
  measure_now(document.mesh());
  return true;
}

void HistogramKeeper::measure_before(Document& document, const KeptRun* reference) {
  const bool unchanged = document.content().skin &&
                         (document.journal().cursor() == 0 || !document.hindrance().empty());
  const Mesh& mesh = unchanged ? document.mesh() : document.copy_mesh_as_loaded().mesh();
  lengths_ = document.wanted_lengths();
  histograms_->wanted_lengths = some_wanted(mesh, lengths_);
  if (!histograms_->wanted_lengths) lengths_.assign(mesh.capacity(0), mean_length(mesh));
  const auto measure = [&](const Mesh& earlier, const Column<Vertex, double>& lengths) {
    regions_before_ = region_contents(earlier);
    for (const HistogramKind kind : kinds)
      histograms_->pairs[static_cast<std::size_t>(kind)].earlier =
          samples_of(kind, earlier, lengths);
  };
  if (reference == nullptr)
    measure(mesh, lengths_);
  else
    measure(BesideMesh(*reference->data).mesh(),
            closed_up(lengths_, std::span<const Vertex>(*reference->vertices)));
}

void HistogramKeeper::measure_now(const Mesh& mesh) {
  histograms_->regions = side_by_side(region_contents(mesh), regions_before_);
  for (const HistogramKind kind : kinds) {
    HistogramPair& pair = histograms_->pairs[static_cast<std::size_t>(kind)];
    pair.samples = samples_of(kind, mesh, lengths_);
    count(kind, histograms_->volume, pair);
  }
}

}  // namespace aomd::scene
