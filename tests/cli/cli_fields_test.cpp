// aomd decimate, replay and classify on meshes that carry arrays, marks of what is required, quads.

#include <set>

#include "core/samples/samples.h"
#include "tests/support/cli_helpers.h"
#include "tests/support/volume_helpers.h"

namespace aomd::test::cli_fields_test {
namespace {

using Point = std::array<double, 3>;

Point point(const MeshData& mesh, std::uint32_t v) {
  const glm::dvec3& p = mesh.positions[v];
  return {p.x, p.y, p.z};
}

/// What is marked, by the places of its vertices.
std::set<std::set<Point>> required(const MeshData& mesh, int dim) {
  std::set<std::set<Point>> places;
  for (const Attribute& a : mesh.attributes) {
    if (a.name != "medit:required" || a.dimension != dim) continue;
    for (std::uint32_t v = 0; dim == 0 && v < mesh.positions.size(); ++v)
      if (a.values[v] != 0) places.insert({point(mesh, v)});
    std::size_t i = 0;
    if (dim == 0) continue;
    io::detail::for_each_entity(mesh.list(dim), [&](auto vertices, ModelRef) {
      std::set<Point> place;
      for (const std::uint32_t v : vertices) place.insert(point(mesh, v));
      if (a.values[i++] != 0) places.insert(place);
    });
  }
  return places;
}

class FieldsCommand : public CommandLine {
 protected:
  /// A bumpy surface with arrays of every kind.
  static MeshData surface() {
    MeshData mesh = make_sample("scan", 1000);
    const std::size_t n = mesh.positions.size(), m = mesh.faces.size();
    Attribute x{"x", 0, 1, false, {}};
    for (const glm::dvec3& p : mesh.positions) x.values.push_back(p.x);
    mesh.attributes = {x,
                       {"uv", 0, 2, false, std::vector<double>(2 * n, 0.5)},
                       {"id", 2, 1, true, std::vector<double>(m, 3)},
                       {"stress", 2, 9, false, std::vector<double>(9 * m, 0.25)}};
    return mesh;
  }
  MeshData read(const char* name) const { return io::read(at(name)).mesh; }
};

TEST_F(FieldsCommand, ArraysGoAlongWithDecimateAndReplay) {
  const MeshData mesh = surface();
  io::write(at("in.vtu"), mesh);
  const Outcome run =
      aomd("decimate in.vtu out.vtu --target-faces 100 --journal j --report r.json");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err.find("left out"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("\n  \"x\" on vertices, interpolated: "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\n  \"id\" on faces, label: 3 to 3\n"), std::string::npos) << run.out;
  const MeshData result = read("out.vtu");
  ASSERT_EQ(result.attributes.size(), 4u);
  for (std::size_t i = 0; i < result.positions.size(); ++i)
    EXPECT_NEAR(result.attributes[0].values[i], result.positions[i].x, 5) << "of 100";
  EXPECT_EQ(result.attributes[1].values, std::vector<double>(2 * result.positions.size(), 0.5));
  EXPECT_EQ(result.attributes[2].values, std::vector<double>(result.faces.size(), 3));
  EXPECT_EQ(result.attributes[3].values, std::vector<double>(9 * result.faces.size(), 0.25));
  EXPECT_EQ(json("r.json")["fields"].size(), 4u);
  EXPECT_EQ(json("r.json")["fields"][3]["kind"], "conserved");
  EXPECT_EQ(aomd("replay in.vtu j again.vtu").err, "");
  EXPECT_EQ(text("again.vtu"), text("out.vtu"));
}

/// A bumpy square of two charts that meet at x = 1/2, as OBJ and as PLY.
TEST_F(FieldsCommand, SeamsStayUnlessTheyAreIgnored) {
  MeshData mesh;
  constexpr std::uint32_t n = 20;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i)
      mesh.positions.emplace_back(double(i) / n, double(j) / n, 0.03 * std::sin(0.9 * i) * (j % 3));
  Attribute uv{"uv", 2, 2, false, {}};
  uv.meaning = Meaning::Texture;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, bool right) {
    mesh.faces.add(Shape::Triangle, {a, b, c});
    for (const std::uint32_t v : {a, b, c}) {
      uv.values.push_back(mesh.positions[v].x + (right ? 10 : 0));
      uv.values.push_back(mesh.positions[v].y);
    }
  };
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t v = j * (n + 1) + i;
      add(v, v + 1, v + n + 2, i >= n / 2);
      add(v, v + n + 2, v + n + 1, i >= n / 2);
    }
  mesh.corners = {uv};
  for (const std::string kind : {".obj", ".ply"}) {
    io::write(at("in" + kind), mesh);
    const std::string run =
        "decimate in" + kind + " out" + kind + " --target-faces 150 --journal j";
    ASSERT_EQ(aomd(run + " --report r.json").code, 0);
    EXPECT_EQ(json("r.json")["options"]["seams"], "keep");
    const MeshData result = io::read(at("out" + kind)).mesh;
    ASSERT_EQ(result.corners.size(), 1u) << kind;
    for (std::size_t c = 0; c < result.faces.vertices.size(); c += 3) {
      double x = 0;
      for (std::size_t k = c; k < c + 3; ++k) x += result.positions[result.faces.vertices[k]].x / 3;
      for (std::size_t k = c; k < c + 3; ++k)
        EXPECT_NEAR(result.corners[0].values[2 * k],
                    result.positions[result.faces.vertices[k]].x + (x < 0.5 ? 0 : 10), 0.05);
    }
    EXPECT_EQ(aomd("replay in" + kind + " j again" + kind).err, "");
    EXPECT_EQ(text("again" + kind), text("out" + kind));
    ASSERT_EQ(aomd(run + " --seams ignore").code, 0);
    EXPECT_NE(text("again" + kind), text("out" + kind));
    EXPECT_EQ(aomd("replay in" + kind + " j again" + kind).err, "");
    EXPECT_EQ(text("again" + kind), text("out" + kind));
  }
  EXPECT_NE(aomd("classify in.obj c.ply").out, aomd("classify in.obj c.ply --seams ignore").out);
  expect_failure("decimate in.obj o.obj --factor 2 --seams tear", 2, "--seams");
}

/// A sphere that is red on one side and blue on the other, with a number and a label beside.
MeshData two_colours() {
  MeshData mesh = make_sample("sphere", 30);
  Attribute colour{"color", 0, 3, true, {}};
  colour.type = NumberType::UInt8;
  colour.meaning = Meaning::Colour;
  Attribute heat{"heat=2", 0, 1, false, {}}, part{"part", 0, 1, true, {}};
  heat.type = NumberType::Float64;
  part.type = NumberType::UInt8;
  for (const glm::dvec3& p : mesh.positions) {
    const bool red = p.x + 0.3 * std::sin(7 * p.y) > 0;
    colour.values.insert(colour.values.end(), {red ? 255.0 : 0.0, 0.0, red ? 0.0 : 255.0});
    heat.values.push_back(p.z > 0 ? 1 : 0);
    part.values.push_back(red ? 1 : 0);
  }
  mesh.attributes = {colour, heat, part};
  return mesh;
}

TEST_F(FieldsCommand, AttributesSaysWhatCountsBesideTheShape) {
  io::write(at("in.ply"), two_colours());
  const auto run = [&](const std::string& words) {
    const std::string command = "decimate in.ply out.ply --target-faces 1500 --report r.json ";
    const auto result = aomd(command + words);
    EXPECT_EQ(result.code, 0) << result.err;
    return text("out.ply");
  };
  const std::string usual = run(""), shape = run("--attributes none");
  EXPECT_EQ(json("r.json")["options"]["attributes"], nlohmann::json::array({"none"}));
  EXPECT_NE(usual, shape);
  EXPECT_EQ(run("--attributes color=0"), shape);
  EXPECT_EQ(run("--attributes color"), usual);
  EXPECT_EQ(run("--attributes none,color"), usual);
  EXPECT_EQ(run("--attributes none,color=3"), usual);
  EXPECT_NE(run("--attributes color=1"), usual);
  EXPECT_NE(run("--attributes heat=2=1"), usual);
  EXPECT_EQ(run("--attributes none,heat=2"), run("--attributes color=0,heat=2=1"));
}

TEST_F(FieldsCommand, WhatCannotCountIsAnError) {
  io::write(at("in.ply"), two_colours());
  io::write(at("box.msh"), make_sample("tet-box", 3));
  const std::string start = "decimate in.ply out.ply --factor 2 --attributes ";
  const std::string there = "; there are: color, heat=2";
  expect_failure(start + "part=1", 2, "named part" + there);
  expect_failure(start + "colour", 2, "named colour" + there);
  expect_failure(start + "color=-1", 2, "between 0 and 1000000, not -1");
  expect_failure(start + "color=much", 2, "between 0 and 1000000, not much");
  expect_failure(start + "color --strategy paper", 2, "--attributes is for --strategy quality");
  expect_failure("decimate box.msh o.msh --factor 2 --attributes none", 2,
                 "--attributes is for surfaces");
}

TEST_F(FieldsCommand, CompareSaysWhatArraysOfSurfacesDifferBy) {
  MeshData mesh = surface();
  io::write(at("a.vtu"), mesh);
  for (double& x : mesh.attributes[0].values) x += 2;
  for (double& x : mesh.attributes[2].values) x = 4;
  io::write(at("b.vtu"), mesh);
  const auto list = nlohmann::json::parse(aomd("compare a.vtu b.vtu --json").out)["fields"];
  ASSERT_EQ(list.size(), 4u);
  EXPECT_NEAR(list[0]["rms"], 2, 1e-12);
  EXPECT_NEAR(list[0]["largest"], 2, 1e-12);
  EXPECT_NEAR(list[1]["rms"], 0, 1e-15);
  EXPECT_NEAR(list[2]["differing_pct"], 100, 1e-9);
  EXPECT_NEAR(list[3]["largest"], 0, 1e-15);
  const std::string out = aomd("compare a.vtu b.vtu").out;
  EXPECT_NE(out.find("field, % of its range"), std::string::npos) << out;
  EXPECT_NE(out.find("% of area"), std::string::npos) << out;
}

/// A square of two triangles, whose texture coordinates jump across the diagonal.
MeshData with_corners(double shift, double tilt_deg) {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.faces.add(Shape::Triangle, {0, 1, 2});
  mesh.faces.add(Shape::Triangle, {0, 2, 3});
  Attribute uv{"uv", 2, 2, false, {}}, normal{"normal", 0, 3, false, {}};
  uv.meaning = Meaning::Texture;
  normal.meaning = Meaning::Normal;
  for (std::size_t c = 0; c < 6; ++c) {
    const glm::dvec3& p = mesh.positions[mesh.faces.vertices[c]];
    uv.values.insert(uv.values.end(), {p.x + shift + (c < 3 ? 0 : 10), p.y});
  }
  const double tilt = tilt_deg * std::acos(-1.0) / 180;
  for (std::size_t v = 0; v < 4; ++v)
    normal.values.insert(normal.values.end(), {std::sin(tilt), 0, std::cos(tilt)});
  mesh.attributes = {normal};
  mesh.corners = {uv};
  return mesh;
}

TEST_F(FieldsCommand, CornersAreComparedAndNormalsByTheirAngle) {
  io::write(at("a.obj"), with_corners(0, 0));
  io::write(at("b.obj"), with_corners(0.25, 30));
  const auto list = nlohmann::json::parse(aomd("compare a.obj b.obj --json").out)["fields"];
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0]["name"], "normal");
  EXPECT_NEAR(list[0]["rms_deg"], 30, 1e-9);
  EXPECT_NEAR(list[0]["largest_deg"], 30, 1e-9);
  EXPECT_EQ(list[1]["name"], "uv");
  EXPECT_EQ(list[1]["on"], "corners");
  EXPECT_TRUE(list[1]["rms_deg"].is_null());
  EXPECT_NEAR(list[1]["rms"], 0.25, 1e-12);
  EXPECT_NEAR(list[1]["largest"], 0.25, 1e-12);
  EXPECT_NEAR(list[1]["rms_pct"], 100 * 0.25 / 11, 1e-9);
  EXPECT_EQ(list[1]["original"]["max"], nlohmann::json::array({11, 1}));
  const std::string out = aomd("compare a.obj b.obj").out;
  EXPECT_NE(out.find("\n    \"normal\" on vertices, deg"), std::string::npos) << out;
  EXPECT_NE(out.find("\n    \"uv\" on corners "), std::string::npos) << out;
}

TEST_F(FieldsCommand, InfoTellsOfCornersAndTheirSeams) {
  io::write(at("a.obj"), with_corners(0, 0));
  const std::string out = aomd("info a.obj").out;
  EXPECT_NE(out.find("  \"uv\" on corners, 2 real numbers: 0 to 11; it jumps across 1 edge\n"),
            std::string::npos)
      << out;
  const auto uv = nlohmann::json::parse(aomd("info a.obj --json").out)["fields"][1];
  EXPECT_EQ(uv["name"], "uv");
  EXPECT_EQ(uv["on"], "corners");
  EXPECT_EQ(uv["seams"], 1);
  EXPECT_EQ(uv["kind"], "interpolated");
  EXPECT_EQ(uv["max"], nlohmann::json::array({11, 1}));
}

TEST_F(FieldsCommand, WhereNothingMovesAllArraysStay) {
  const MeshData mesh = surface();
  io::write(at("in.vtu"), mesh);
  const std::string target = std::to_string(mesh.faces.size());
  const std::string nothing = " --no-swap --no-smooth --journal j --target-faces " + target;
  EXPECT_EQ(aomd("decimate in.vtu out.vtu" + nothing).err, "");
  EXPECT_EQ(aomd("replay in.vtu j again.vtu").err, "");
  EXPECT_EQ(aomd("repair in.vtu mended.vtu").err, "");
  EXPECT_EQ(aomd("classify in.vtu classified.vtu").err, "");
  for (const char* name : {"out.vtu", "again.vtu", "mended.vtu", "classified.vtu"}) {
    const MeshData result = read(name);
    for (const Attribute& a : mesh.attributes)
      EXPECT_EQ(std::count(result.attributes.begin(), result.attributes.end(), a), 1)
          << name << ' ' << a.name;
  }
}

TEST_F(FieldsCommand, WhatAFormatDoesNotHoldIsSaid) {
  MeshData mesh = surface();
  mesh.attributes.push_back(
      {"medit:reference", 0, 1, true, std::vector<double>(mesh.positions.size(), 4)});
  io::write(at("in.vtu"), mesh);
  const std::string fields = "attribute \"x\", attribute \"uv\", ",
                    others = "attribute \"id\", attribute \"stress\"\n";
  for (const char* name : {"o.obj", "o.off", "o.stl"})
    EXPECT_EQ(aomd(std::string("convert in.vtu ") + name).err,
              std::string("aomd: note: ") + name + ": left out: " + fields +
                  "attribute \"medit:reference\", " + others);
  EXPECT_EQ(aomd("repair in.vtu o.mesh").err,
            "aomd: note: o.mesh: left out: attribute \"uv\", attribute \"id\", the name \"x\", the "
            "name \"stress\"\n");
  for (const char* name : {"o.ply", "o.vtk", "o.vtu", "o.msh"})
    EXPECT_EQ(aomd(std::string("convert in.vtu ") + name).err, "");
}

TEST_F(FieldsCommand, WhatIsRequiredStaysAndIsWrittenAgain) {
  MeshData mesh = surface();
  mesh.attributes = {{"medit:required", 0, 1, true, std::vector<double>(mesh.positions.size())},
                     {"medit:required", 2, 1, true, std::vector<double>(mesh.faces.size())}};
  for (const std::size_t v : {45u, 46u, 190u}) mesh.attributes[0].values[v] = 1;
  for (const std::size_t f : {100u, 101u, 377u, 500u}) mesh.attributes[1].values[f] = 1;
  const std::uint32_t* v = mesh.faces.vertices.data() + 3 * 600;
  mesh.edges.add(Shape::Line, {v[0], v[1]}, ModelRef(1, 0));
  mesh.edges.add(Shape::Line, {v[1], v[2]}, ModelRef(1, 0));
  mesh.attributes.push_back({"medit:required", 1, 1, true, {1, 1}});
  io::write(at("in.mesh"), mesh);
  const MeshData before = read("in.mesh");
  for (const char* how :
       {"--strategy quality", "--strategy paper", "--strategy paper --improve 9"}) {
    const Outcome run = aomd(std::string("decimate in.mesh out.mesh --target-faces 60 ") + how);
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.err.find("required vertices kept in place\n"), std::string::npos);
    const MeshData after = read("out.mesh");
    EXPECT_LT(after.faces.size(), 300u);  // of about 1000
    EXPECT_EQ(required(before, 0).size(), 3u);
    EXPECT_EQ(required(before, 1).size(), 2u);
    EXPECT_EQ(required(before, 2).size(), 4u);
    for (int dim = 0; dim <= 2; ++dim)
      EXPECT_EQ(required(after, dim), required(before, dim)) << how;
  }
}

/// A diagonal that either strategy swaps, unless a triangle at it is required.
TEST_F(FieldsCommand, RequiredTrianglesAreNotSwapped) {
  MeshData mesh;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) mesh.positions.emplace_back(i, j, 0);
  mesh.positions[6] = {0.6, 0.6, 0};
  mesh.positions[12] = {2.4, 2.4, 0};
  for (std::uint32_t v = 0; v < 19; ++v) {
    if (v % 5 == 4) continue;
    mesh.faces.add(Shape::Triangle, {v, v + 1, v + 6});
    mesh.faces.add(Shape::Triangle, {v, v + 6, v + 5});
  }
  const auto has_diagonal = [](const MeshData& m) {
    bool found = false;
    io::detail::for_each_entity(m.faces, [&](auto v, ModelRef) {
      const auto is = [&](double x) {
        return std::any_of(v.begin(), v.end(),
                           [&](std::uint32_t i) { return m.positions[i] == glm::dvec3(x, x, 0); });
      };
      found = found || (is(0.6) && is(2.4));
    });
    return found;
  };
  io::write(at("free.mesh"), mesh);
  mesh.attributes = {{"medit:required", 2, 1, true, std::vector<double>(32)}};
  mesh.attributes[0].values[10] = 1;
  io::write(at("held.mesh"), mesh);
  for (const char* how : {" --target-faces 32", " --strategy paper --factor 0.5"}) {
    ASSERT_EQ(aomd(std::string("decimate free.mesh out.mesh --no-smooth") + how).code, 0);
    EXPECT_FALSE(has_diagonal(read("out.mesh"))) << how;
    ASSERT_EQ(aomd(std::string("decimate held.mesh out.mesh --no-smooth") + how).code, 0);
    EXPECT_TRUE(has_diagonal(read("out.mesh"))) << how;
    EXPECT_EQ(required(read("out.mesh"), 2), required(read("held.mesh"), 2));
  }
}

TEST_F(FieldsCommand, QuadsAreCutWhereThatIsAskedFor) {
  MeshData mesh;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) mesh.positions.emplace_back(i, j, 0);
  for (std::uint32_t j = 0; j < 3; ++j)
    for (std::uint32_t i = 0; i < 3; ++i)
      mesh.faces.add(Shape::Quad, {4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4},
                     ModelRef(2, i < 2 ? 5 : 6));
  io::write(at("q.msh"), mesh);
  expect_failure("decimate q.msh o.msh --target-faces 4", 5, "there are quads: --triangulate");
  const Outcome run = aomd("decimate q.msh o.msh --target-faces 18 --triangulate --journal j");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err.find("aomd: note: q.msh: 9 quads cut into triangles\n"), 0u) << run.err;
  const MeshData result = read("o.msh");
  EXPECT_EQ(result.faces.shapes, std::vector<Shape>(18, Shape::Triangle));
  EXPECT_EQ(std::count(result.faces.classes.begin(), result.faces.classes.end(), ModelRef(2, 5)),
            12);
  EXPECT_EQ(aomd("replay q.msh j o2.msh --triangulate").code, 0);
  EXPECT_EQ(text("o2.msh"), text("o.msh"));
}

/// Materials and the picture lie beside an OBJ, and go along wherever it does.
TEST_F(FieldsCommand, MaterialsAndPicturesGoAlong) {
  ASSERT_EQ(aomd("sample globe g.obj --size 4").code, 0);
  EXPECT_NE(aomd("info g.obj").out.find("  material \"globe\", picture \"globe.png\"\n"),
            std::string::npos);
  std::filesystem::create_directory(at("there"));
  ASSERT_EQ(aomd("decimate g.obj there/d.obj --target-faces 100 --quiet").code, 0);
  EXPECT_EQ(bytes_of(at("there/globe.png")), bytes_of(at("globe.png")));
  EXPECT_EQ(bytes_of(at("there/g.mtl")), bytes_of(at("g.mtl")));
  const auto list = nlohmann::json::parse(aomd("info there/d.obj --json").out)["materials"];
  EXPECT_EQ(list, nlohmann::json::parse(
                      R"([{"name":"globe","color":[1.0,1.0,1.0,1.0],"picture":"globe.png"}])"));
}

/// Standard output, wherever it leads, takes one file: nothing is put beside it.
TEST_F(FieldsCommand, NothingLiesBesideStandardOutput) {
  ASSERT_EQ(aomd("sample globe g.obj --size 2").code, 0);
  const std::string text = aomd("convert g.obj - --format obj").out;
  EXPECT_NE(text.find("mtllib g.mtl\n"), std::string::npos);
  ASSERT_EQ(aomd("convert g.obj - --format ply").code, 0);
  for (const char* name : {"/dev/g.mtl", "/dev/stdout.mtl", "/dev/globe.png", "/dev/stdout.bin"})
    EXPECT_FALSE(std::filesystem::exists(name)) << name;
  const auto known = aomd("convert g.obj - --format gltf --ascii");
  EXPECT_NE(known.out.find(known.code == 0 ? "data:application/octet-stream;base64," : ""),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists("/dev/stdout.bin"));
}

}  // namespace
}  // namespace aomd::test::cli_fields_test
