// The file of arrays beside a Medit mesh.

#include <algorithm>

#include <gtest/gtest.h>

#include "core/io/io.h"
#include "tests/support/io_helpers.h"

namespace aomd::test::io_medit_solution_test {
namespace {

const std::string two_triangles =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n"
    "Triangles\n2\n1 2 3 1\n1 3 4 1\nEnd\n";

class MeditSolution : public testing::Test {
 protected:
  io::ReadResult read(const std::string& solution, const std::string& mesh = two_triangles) {
    io::write_file(folder_ / "a.mesh", mesh);
    io::write_file(folder_ / "a.sol", solution);
    return io::read(folder_ / "a.mesh");
  }
  void expect_error(const std::string& solution, const std::string& what) {
    try {
      (void)read(solution);
      ADD_FAILURE() << "no error: " << what;
    } catch (const io::ReadError& e) {
      EXPECT_NE(std::string(e.what()).find("a.sol:"), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find(what), std::string::npos) << e.what();
    }
  }
  TemporaryFolder folder_;
};

TEST_F(MeditSolution, HasTypesForEachKindOfEntity) {
  const MeshData mesh = read(
                            "MeshVersionFormatted 2\nDimension\n3\n\nSolAtVertices\n4\n2 1 2\n"
                            "1 10 11 12\n2 20 21 22\n3 30 31 32\n4 40 41 42\n\n"
                            "SolAtTriangles\n2\n1 3\n1 2 3 4 5 6\n7 8 9 10 11 12\nEnd\n")
                            .mesh;
  ASSERT_EQ(mesh.attributes.size(), 3u);
  EXPECT_EQ(mesh.attributes[0], (Attribute{"solution", 0, 1, false, {1, 2, 3, 4}}));
  EXPECT_EQ(
      mesh.attributes[1],
      (Attribute{"solution 2", 0, 3, false, {10, 11, 12, 20, 21, 22, 30, 31, 32, 40, 41, 42}}));
  EXPECT_EQ(mesh.attributes[2],
            (Attribute{"solution", 2, 6, false, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}}));
}

TEST_F(MeditSolution, VectorsInThePlaneHaveTwoComponents) {
  const MeshData mesh = read(
                            "MeshVersionFormatted 2 Dimension 2 SolAtVertices 4 2 2 3 "
                            "1 2 3 4 5 1 2 3 4 5 1 2 3 4 5 1 2 3 4 5 End")
                            .mesh;
  ASSERT_EQ(mesh.attributes.size(), 2u);
  EXPECT_EQ(mesh.attributes[0].components, 2);
  EXPECT_EQ(mesh.attributes[1].components, 3);
}

TEST_F(MeditSolution, WhatDoesNotFitIsAnError) {
  const std::string start = "MeshVersionFormatted 2\nDimension 3\n";
  expect_error(start + "SolAtVertices\n5\n1 1\n1 2 3 4 5\nEnd\n",
               "SolAtVertices has values for 5, and the mesh has 4 of these");
  expect_error(start + "SolAtVertices\n3\n1 1\n1 2 3\nEnd\n",
               "SolAtVertices has values for 3, and the mesh has 4 of these");
  expect_error(start + "SolAtTetrahedra\n1\n1 1\n1\nEnd\n",
               "SolAtTetrahedra has values for 1, and the mesh has 0 of these");
  expect_error(start + "SolAtVertices\n4\n1 5\n1 2 3 4\nEnd\n", "type 5");
  expect_error(start + "SolAtVertices\n4\n1000000000 1\n1 2 3 4\nEnd\n", "too short");
  expect_error(start + "SolAtVertices\n4\n1 1\n1 2 3\nEnd\n", "a value");
  expect_error("MeshVersionFormatted 2\nSolAtVertices\n4\n1 1\n1 2 3 4\nEnd\n", "no Dimension");
  expect_error("solution\n", "does not start with MeshVersionFormatted");
}

/// Nodes that only an element of higher order has are not in the mesh.
TEST_F(MeditSolution, IsLeftOutWhereTheMeshIsNotAsItsFileHasIt) {
  const io::ReadResult result =
      read("MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n6\n1 1\n1 2 3 4 5 6\nEnd\n",
           "MeshVersionFormatted 2\nDimension 3\nVertices\n6\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
           ".5 0 0 0\n.5 .5 0 0\n0 .5 0 0\nTrianglesP2\n1\n1 2 3 4 5 6 1\nEnd\n");
  EXPECT_TRUE(result.mesh.attributes.empty());
  EXPECT_EQ(std::count(result.notes.begin(), result.notes.end(),
                       "a.sol left out: the mesh is not as its file has it"),
            1);
}

TEST_F(MeditSolution, NamesAreLostAndWhatHasNoTypeToo) {
  MeshData mesh = read("MeshVersionFormatted 2\nDimension 3\nEnd\n").mesh;
  mesh.attributes = {{"heat", 0, 1, false, {1, 2, 3, 4}},
                     {"uv", 0, 2, false, std::vector<double>(8)},
                     {"id", 2, 1, true, {1, 2}}};
  const std::vector<std::string> notes = io::write(folder_ / "b.mesh", mesh);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0], "left out: attribute \"uv\", attribute \"id\", the name \"heat\"");
  const MeshData again = io::read(folder_ / "b.mesh").mesh;
  ASSERT_EQ(again.attributes.size(), 1u);
  EXPECT_EQ(again.attributes[0], (Attribute{"solution", 0, 1, false, {1, 2, 3, 4}}));
  EXPECT_EQ(bytes_of(folder_ / "b.sol"),
            "MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n4\n"
            "1 1\n1\n2\n3\n4\nEnd\n");
}

TEST_F(MeditSolution, OneFromBeforeIsSaid) {
  MeshData mesh = read("MeshVersionFormatted 2\nDimension 3\nEnd\n").mesh;
  EXPECT_EQ(
      io::write(folder_ / "a.mesh", mesh),
      std::vector<std::string>{"a.sol is there from before, and does not belong to the mesh"});
}

}  // namespace
}  // namespace aomd::test::io_medit_solution_test
