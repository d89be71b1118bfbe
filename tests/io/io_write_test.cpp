#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "core/io/formats.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"

namespace aomd::io_write_test {
namespace {

using test::bytes_of;
using test::TemporaryFolder;
namespace fs = std::filesystem;

std::string write_error(const fs::path& path, std::string_view bytes) {
  try {
    io::write_file(path, bytes);
    return "";
  } catch (const io::WriteError& error) {
    return error.what();
  }
}

TEST(WriteFile, WritesAndReplaces) {
  const TemporaryFolder folder;
  io::write_file(folder / "a", "first");
  io::write_file(folder / "a", "second");
  EXPECT_EQ(bytes_of(folder / "a"), "second");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(WriteFile, KeepsThePermissionsOfTheOldFile) {
  const TemporaryFolder folder;
  io::write_file(folder / "a", "first");
  fs::permissions(folder / "a",
                  fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  io::write_file(folder / "a", "second");
  EXPECT_EQ(fs::status(folder / "a").permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST(WriteFile, NewFilesFollowTheMask) {
  const TemporaryFolder folder;
  const mode_t old = ::umask(027);
  io::write_file(folder / "a", "x");
  ::umask(old);
  EXPECT_EQ(static_cast<unsigned>(fs::status(folder / "a").permissions()), 0640u);
}

TEST(WriteFile, FollowsLinks) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "there");
  io::write_file(folder / "there/real", "old");
  fs::create_symlink("there/real", folder / "link");
  fs::create_symlink("there/later", folder / "dangling");
  io::write_file(folder / "link", "new");
  io::write_file(folder / "dangling", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(bytes_of(folder / "there/real"), "new");
  EXPECT_EQ(bytes_of(folder / "there/later"), "new");
}

TEST(WriteFile, SaysWhatIsInTheWay) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "d");
  EXPECT_NE(write_error(folder / "d", "x").find("folder"), std::string::npos);
  EXPECT_NE(write_error(folder / "none/a", "x").find("No such file"), std::string::npos);
  EXPECT_NE(write_error("/dev/full", "x").find("No space left"), std::string::npos);
  EXPECT_TRUE(fs::is_character_file("/dev/full")) << "a device must not be replaced";
  EXPECT_EQ(write_error("/dev/null", "x"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

/// Files of this process cannot grow beyond a limit, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    old_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_{};
  void (*old_handler_)(int);
};

TEST(WriteFile, AFullDiskLeavesTheOldFileAndNoOther) {
  const TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.stl"}) {
    io::write(folder / name, make_sample("box", 1));
    const std::string before = bytes_of(folder / name);
    const std::size_t entries = folder.entries();
    {
      const FullDisk full(4096);
      EXPECT_THROW(io::write(folder / name, make_sample("box", 20)), io::WriteError);
      EXPECT_THROW(io::write(folder / "new.ply", make_sample("box", 20)), io::WriteError);
    }
    EXPECT_EQ(bytes_of(folder / name), before);
    EXPECT_EQ(folder.entries(), entries);
  }
}

TEST(WriteFile, AWriteProtectedFileStays) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  const TemporaryFolder folder;
  io::write_file(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms::owner_read);
  EXPECT_NE(write_error(folder / "a", "new"), "");
  EXPECT_EQ(bytes_of(folder / "a"), "old");
}

TEST(Write, TheExtensionChooses) {
  const TemporaryFolder folder;
  const MeshData mesh = make_sample("box", 1);
  for (const char* name : {"a.ply", "a.OBJ", "a.off", "a.Stl"}) {
    io::write(folder / name, mesh);
    EXPECT_EQ(io::read(folder / name).mesh.faces.size(), 12u) << name;
  }
  EXPECT_THROW(io::write(folder / "a.xyz", mesh), io::WriteError);
  EXPECT_THROW(io::write(folder / "a", mesh), io::WriteError);
}

TEST(Write, RegionsAndWhatDoesNotFitAreRefused) {
  const TemporaryFolder folder;
  MeshData mesh = make_sample("box", 1);
  mesh.positions[0].x = 1e300;
  EXPECT_THROW(io::write(folder / "a.stl", mesh, {.binary = true}), io::WriteError);
  io::write(folder / "a.ply", mesh);
  EXPECT_EQ(io::read(folder / "a.ply").mesh.positions[0].x, 1e300);
  for (const double x :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    mesh.positions[0].x = x;
    EXPECT_THROW(io::write(folder / "a.ply", mesh), io::WriteError);
  }
  mesh = make_sample("box", 1);
  mesh.regions.add(Shape::Tetrahedron, {0, 1, 2, 3});
  EXPECT_THROW(io::write(folder / "a.ply", mesh), io::WriteError);
}

// What is written can be read, also where there is nothing.
TEST(WriteMesh, NothingReadsBackInEveryFormat) {
  const TemporaryFolder folder;
  std::vector<std::string> names{"a.obj",  "a.off",   "a.ply", "a.stl", "a.msh",
                                 "a.mesh", "a.meshb", "a.vtk", "a.vtu", "a.su2"};
  if (io::detail::has_gltf()) names.insert(names.end(), {"a.gltf", "a.glb"});
  for (const std::string& name : names) {
    io::write(folder / name.c_str(), MeshData());
    EXPECT_TRUE(io::read(folder / name.c_str()).mesh.positions.empty()) << name;
  }
}

}  // namespace
}  // namespace aomd::io_write_test
