// aomd decimate, replay, compare and info on volumes with arrays.

#include "core/fields/cells.h"
#include "core/fields/field.h"
#include "core/samples/samples.h"
#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_volume_fields_test {
namespace {

constexpr int sizes[] = {1, 2, 3, 4, 6, 9};

/// A ball in a box with arrays of every kind, on vertices and regions; `reals` only where the
/// format has no whole numbers.
MeshData with_arrays(bool reals) {
  MeshData mesh = make_sample("ball-in-box", 3);
  const fields::Cells cells(mesh, 3);
  const auto add = [&](const std::string& name, int dim, int components, bool integer) {
    Attribute a{name, dim, components, integer, {}};
    const std::size_t n = dim == 0 ? mesh.positions.size() : cells.size();
    for (std::uint32_t i = 0; i < n; ++i) {
      const glm::dvec3 p = dim == 0 ? mesh.positions[i] : cells.centre(i);
      for (int k = 0; k < components; ++k)
        a.values.push_back(integer ? std::floor(4 * p.x) : (k + 1) * (1 + p.x - 2 * p.y + 3 * p.z));
    }
    mesh.attributes.push_back(std::move(a));
  };
  for (const int n : sizes) {
    add("on vertices, " + std::to_string(n), 0, n, false);
    add("on regions, " + std::to_string(n), 3, n, false);
  }
  if (!reals) {
    add("number", 0, 1, true);
    add("part", 3, 1, true);
  }
  return mesh;
}

struct Way {
  const char* input;
  bool binary, msh2;
};

class VolumeFields : public CommandLine {
 protected:
  MeshData read(const std::string& name) const { return io::read(at(name)).mesh; }

  void expect_carried(const MeshData& before, const MeshData& after) const {
    ASSERT_EQ(after.attributes.size(), before.attributes.size());
    const std::vector<double> was = fields::measures(before, 3), is = fields::measures(after, 3);
    for (const Attribute& a : before.attributes) {
      const auto b = std::find_if(after.attributes.begin(), after.attributes.end(),
                                  [&](const Attribute& x) { return x.name == a.name; });
      ASSERT_NE(b, after.attributes.end()) << a.name;
      EXPECT_EQ(b->dimension, a.dimension);
      EXPECT_EQ(b->components, a.components);
      EXPECT_EQ(b->integer, a.integer);
      if (a.integer) continue;
      if (a.dimension == 0) expect_linear(after, *b);
      if (a.dimension == 3)
        expect_integrals(fields::facts_of(a, was), fields::facts_of(*b, is), a.name);
    }
  }
  static void expect_linear(const MeshData& mesh, const Attribute& a) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      for (int k = 0; k < a.components; ++k) {
        const glm::dvec3& p = mesh.positions[i];
        ASSERT_NEAR(
            a.values[static_cast<std::size_t>(a.components) * i + static_cast<std::size_t>(k)],
            (k + 1) * (1 + p.x - 2 * p.y + 3 * p.z), 1e-12 * (k + 1))
            << a.name;
      }
  }
  static void expect_integrals(const fields::FieldFacts& was, const fields::FieldFacts& is,
                               const std::string& name) {
    for (std::size_t k = 0; k < was.components.size(); ++k)
      EXPECT_NEAR(is.components[k].integral, was.components[k].integral,
                  1e-12 * std::abs(was.components[k].integral))
          << name << ' ' << k;
  }
};

TEST_F(VolumeFields, GoAlongInEveryFormatThatHoldsThem) {
  for (const Way& way :
       {Way{"in.vtk", false, false}, Way{"in.vtk", true, false}, Way{"in.vtu", false, false},
        Way{"in.vtu", true, false}, Way{"in.msh", false, false}, Way{"in.msh", true, false},
        Way{"in.msh", false, true}, Way{"in.msh", true, true}}) {
    const std::string in = way.input, out = "out" + in.substr(2), again = "again" + in.substr(2);
    SCOPED_TRACE(in + (way.binary ? " binary" : " text") + (way.msh2 ? " 2.2" : ""));
    const MeshData mesh = with_arrays(in == "in.msh");
    io::write(at(in), mesh, {.binary = way.binary, .msh2 = way.msh2});
    const Outcome run =
        aomd("decimate " + in + ' ' + out + " --target-tets 25% --journal j --report r.json");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err.find("left out"), std::string::npos) << run.err;
    const MeshData result = read(out);
    EXPECT_LT(result.regions.size(), mesh.regions.size() / 3);
    expect_carried(read(in), result);
    ASSERT_EQ(aomd("replay " + in + " j " + again).code, 0);
    EXPECT_EQ(text(again), text(out));
    EXPECT_EQ(json("r.json")["fields"].size(), mesh.attributes.size());
  }
}

TEST_F(VolumeFields, TheReportHasRangesAndIntegrals) {
  ASSERT_EQ(aomd("sample layered-beam in.vtu --size 3").code, 0);
  const Outcome run = aomd("decimate in.vtu out.vtu --target-tets 25% --report r.json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("  \"temperature\" on vertices, interpolated: 300 to 400, integral 28000 "
                         "kept\n  \"stress\" on regions, conserved: "),
            std::string::npos)
      << run.out;
  const auto list = json("r.json")["fields"];
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0]["name"], "temperature");
  EXPECT_EQ(list[0]["on"], "vertices");
  EXPECT_EQ(list[0]["kind"], "interpolated");
  EXPECT_EQ(list[0]["components"], 1);
  for (const char* when : {"before", "after"}) {
    EXPECT_NEAR(list[0][when]["min"][0], 300, 1e-12);
    EXPECT_NEAR(list[0][when]["max"][0], 400, 1e-12);
    EXPECT_NEAR(list[0][when]["integral"][0], 80 * 350.0, 1e-9);
    EXPECT_EQ(list[0][when]["missing"], 0);
  }
  EXPECT_EQ(list[1]["kind"], "conserved");
  EXPECT_NEAR(list[1]["before"]["integral"][0], list[1]["after"]["integral"][0], 1e-10);
  EXPECT_EQ(aomd("decimate in.vtu out.vtu --target-tets 25% --quiet").out, "");
}

TEST_F(VolumeFields, WithoutArraysNothingIsSaid) {
  ASSERT_EQ(aomd("sample tet-box in.vtu --size 4").code, 0);
  const Outcome run = aomd("decimate in.vtu out.vtu --target-tets 50% --report r.json");
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out.find("integral"), std::string::npos) << run.out;
  EXPECT_EQ(json("r.json")["fields"], nlohmann::json::array());
  EXPECT_FALSE(json("r.json")["seconds"].contains("fields"));
}

TEST_F(VolumeFields, InfoListsThem) {
  MeshData mesh = make_sample("tet-box", 2);
  mesh.attributes = {{"a b", 0, 3, false, std::vector<double>(3 * mesh.positions.size(), 1.5)},
                     {"part", 3, 1, true, std::vector<double>(mesh.regions.size(), -2)}};
  mesh.attributes[0].values[0] = -4;
  mesh.attributes[0].values[5] = std::nan("");
  io::write(at("in.vtu"), mesh);
  EXPECT_NE(
      aomd("info in.vtu")
          .out.find(
              "  \"a b\" on vertices, 3 real numbers: -4 to 1.5, 1 value no number\n  \"part\" on "
              "regions, 1 whole number: -2 to -2\n"),
      std::string::npos)
      << aomd("info in.vtu").out;
  const auto list = nlohmann::json::parse(aomd("info in.vtu --json").out)["fields"];
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0]["name"], "a b");
  EXPECT_EQ(list[0]["on"], "vertices");
  EXPECT_EQ(list[0]["type"], "real");
  EXPECT_EQ(list[0]["components"], 3);
  EXPECT_EQ(list[0]["min"], nlohmann::json({-4, 1.5, 1.5}));
  EXPECT_EQ(list[0]["missing"], 1);
  EXPECT_EQ(list[1]["type"], "whole");
  EXPECT_EQ(list[1]["max"], nlohmann::json({-2}));
}

TEST_F(VolumeFields, CompareSaysWhatTheyDifferBy) {
  MeshData mesh = make_sample("mixed", 4);
  const std::size_t n = mesh.positions.size(), m = mesh.regions.size();
  mesh.attributes = {{"u", 0, 1, false, {}},
                     {"v", 3, 2, false, std::vector<double>(2 * m, 1)},
                     {"part", 3, 1, true, std::vector<double>(m, 1)},
                     {"mine", 0, 1, false, std::vector<double>(n, 1)}};
  for (const glm::dvec3& p : mesh.positions) mesh.attributes[0].values.push_back(10 * p.x);
  mesh.attributes[1].values[0] = 0;
  MeshData other = mesh;
  other.attributes.pop_back();
  for (double& x : other.attributes[0].values) x += 0.5;
  for (std::size_t i = 0; i < m; ++i) other.attributes[1].values[2 * i] += 3;
  for (std::size_t i = 0; i < m; ++i) other.attributes[1].values[2 * i + 1] += 4;
  for (double& x : other.attributes[2].values) x = 2;
  io::write(at("a.vtu"), mesh);
  io::write(at("b.vtu"), other);
  const auto same = nlohmann::json::parse(aomd("compare a.vtu a.vtu --json").out);
  for (const auto& f : same["fields"]) {
    const bool label = f["name"] == "part";
    EXPECT_LE(f[label ? "differing_pct" : "largest"], label ? 0 : 1e-14) << f;
  }
  const auto list = nlohmann::json::parse(aomd("compare a.vtu b.vtu --json").out)["fields"];
  ASSERT_EQ(list.size(), 3u) << "one mesh alone has the last";
  EXPECT_NEAR(list[0]["rms"], 0.5, 1e-12);
  EXPECT_NEAR(list[0]["largest"], 0.5, 1e-12);
  const double range =
      list[0]["original"]["max"][0].get<double>() - list[0]["original"]["min"][0].get<double>();
  EXPECT_NEAR(list[0]["rms_pct"], 50 / range, 1e-9);
  EXPECT_NEAR(list[1]["rms"], 5, 1e-12) << "of vectors the length";
  EXPECT_NEAR(list[1]["largest_pct"], 500, 1e-9);
  EXPECT_TRUE(list[0]["differing_pct"].is_null());
  EXPECT_TRUE(list[2]["rms"].is_null());
  EXPECT_NEAR(list[2]["differing_pct"], 100, 1e-12);
  const std::string out = aomd("compare a.vtu b.vtu").out;
  EXPECT_NE(out.find("field, % of its range"), std::string::npos) << out;
  EXPECT_NE(out.find("  \"part\" on regions"), std::string::npos) << out;
}

}  // namespace
}  // namespace aomd::test::cli_volume_fields_test
