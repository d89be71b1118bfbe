// Outputs that appear together or not at all, beside what else may stand in their folders.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "core/io/output_files.h"
#include "core/io/output_target.h"
#include "tests/support/io_helpers.h"

namespace aomd::io_output_files_test {
namespace {

using test::bytes_of;
using test::TemporaryFolder;
namespace fs = std::filesystem;

std::string error_of_writing(const fs::path& path) {
  try {
    io::write_file(path, "new");
    return "";
  } catch (const io::WriteError& error) {
    return error.what();
  }
}

/// A name that a temporary of this process may have.
std::string temporary_name(int number) {
  return ".aomd-" + std::to_string(::getpid()) + "-" + std::to_string(number) + ".tmp";
}

TEST(OutputFiles, MayHaveTheLongestNames) {
  const TemporaryFolder folder;
  for (const std::size_t length : {240u, 246u, 255u}) {
    const std::string name(length, 'n');
    EXPECT_EQ(error_of_writing(folder / name.c_str()), "");
    EXPECT_EQ(bytes_of(folder / name.c_str()), "new");
  }
  EXPECT_NE(error_of_writing(folder / std::string(256, 'n').c_str()).find("File name too long"),
            std::string::npos);
  EXPECT_EQ(folder.entries(), 3u);
}

TEST(OutputFiles, NeverTouchWhatHasTheNameOfATemporary) {
  const TemporaryFolder folder;
  io::write_file(folder / "victim", "precious");
  constexpr int links = 8;
  for (int i = 0; i < links; ++i) fs::create_symlink("victim", folder / temporary_name(i).c_str());
  fs::create_symlink("nowhere", folder / temporary_name(links).c_str());
  fs::create_directory(folder / temporary_name(links + 1).c_str());
  EXPECT_EQ(error_of_writing(folder / "a"), "");
  EXPECT_EQ(bytes_of(folder / "a"), "new");
  EXPECT_EQ(bytes_of(folder / "victim"), "precious");
  EXPECT_FALSE(fs::exists(folder / "nowhere"));
  EXPECT_EQ(folder.entries(), links + 4u);
}

TEST(OutputFiles, OfKilledProgramsAreRemovedAndThoseOfOthersAtWorkAreNot) {
  const TemporaryFolder folder;
  for (const char* name :
       {".aomd-1-0.tmp", ".aomd-4194304-3.tmp", ".aomd-at-work.tmp", ".aomd-1-0", "b.tmp"})
    std::ofstream(folder / name) << "left";
  const int at_work = ::open((folder / ".aomd-at-work.tmp").c_str(), O_RDONLY);
  ASSERT_EQ(::flock(at_work, LOCK_EX), 0);
  io::write_file(folder / "a", "new");
  EXPECT_FALSE(fs::exists(folder / ".aomd-1-0.tmp"));
  EXPECT_FALSE(fs::exists(folder / ".aomd-4194304-3.tmp"));
  EXPECT_TRUE(fs::exists(folder / ".aomd-at-work.tmp"));
  EXPECT_TRUE(fs::exists(folder / ".aomd-1-0"));
  EXPECT_TRUE(fs::exists(folder / "b.tmp"));
  ::close(at_work);
}

TEST(OutputFiles, AppearTogether) {
  const TemporaryFolder folder;
  io::write_file(folder / "a", "old");
  io::OutputFiles files;
  for (const char* name : {"a", "b", "c"}) files.add(folder / name, "new");
  EXPECT_EQ(bytes_of(folder / "a"), "old");
  EXPECT_FALSE(fs::exists(folder / "b"));
  files.commit();
  for (const char* name : {"a", "b", "c"}) EXPECT_EQ(bytes_of(folder / name), "new");
  EXPECT_EQ(folder.entries(), 3u);
}

TEST(OutputFiles, ThatAreNotCommittedLeaveNothing) {
  const TemporaryFolder folder;
  {
    io::OutputFiles files;
    for (const char* name : {"a", "b"}) files.add(folder / name, "new");
    EXPECT_EQ(folder.entries(), 2u);
  }
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(OutputFiles, AreAllTakenBackWhereOneCannotBePutInPlace) {
  const TemporaryFolder folder;
  io::write_file(folder / "a", "old");
  {
    io::OutputFiles files;
    for (const char* name : {"a", "b", "c", "d"}) files.add(folder / name, "new");
    fs::create_directory(folder / "c");
    EXPECT_THROW(files.commit(), io::WriteError);
  }
  EXPECT_EQ(bytes_of(folder / "a"), "old");
  EXPECT_FALSE(fs::exists(folder / "b"));
  EXPECT_FALSE(fs::exists(folder / "d"));
  EXPECT_EQ(folder.entries(), 2u);
}

TEST(OutputFiles, StayAsTheyWereWhereADeviceIsFull) {
  const TemporaryFolder folder;
  io::write_file(folder / "a", "old");
  {
    io::OutputFiles files;
    files.add(folder / "a", "new");
    files.add("/dev/full", "new");
    EXPECT_THROW(files.commit(), io::WriteError);
  }
  EXPECT_EQ(bytes_of(folder / "a"), "old");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(OutputFiles, ALoopOfLinksIsAnErrorAndStays) {
  const TemporaryFolder folder;
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  EXPECT_NE(error_of_writing(folder / "a").find("symbolic links"), std::string::npos);
  EXPECT_TRUE(fs::is_symlink(folder / "a"));
  EXPECT_EQ(folder.entries(), 2u);
}

TEST(OutputFiles, APipeGetsTheBytes) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = bytes_of(folder / "pipe"); });
  io::write_file(folder / "pipe", "new");
  reader.join();
  EXPECT_EQ(got, "new");
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
  EXPECT_EQ(folder.entries(), 1u);
}

// A pipe that does not block takes a part of it.
TEST(OutputFiles, APartOfTheBytesIsNotAllOfThem) {
  int ends[2];
  ASSERT_EQ(::pipe2(ends, O_NONBLOCK | O_CLOEXEC), 0);
  EXPECT_TRUE(io::detail::write_all(ends[1], std::string(100, 'x')));
  EXPECT_FALSE(io::detail::write_all(ends[1], std::string(1 << 22, 'x')));
  ::close(ends[0]), ::close(ends[1]);
}

TEST(OutputFiles, KeepThePermissionsOfWhatTheyReplace) {
  const TemporaryFolder folder;
  for (const ::mode_t mode : {0600u, 0640u, 0755u}) {
    io::write_file(folder / "a", "old");
    ASSERT_EQ(::chmod((folder / "a").c_str(), mode), 0);
    io::write_file(folder / "a", "new");
    struct stat info {};
    ASSERT_EQ(::stat((folder / "a").c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 07777u, mode);
  }
}

TEST(OutputFiles, ADescriptorGoesOnWhereItIs) {
  const TemporaryFolder folder;
  std::ofstream(folder / "log") << "before ";
  const int fd = ::open((folder / "log").c_str(), O_WRONLY | O_APPEND);
  fs::create_symlink("/dev/fd/" + std::to_string(fd), folder / "link");
  io::write_file("/dev/fd/" + std::to_string(fd), "one ");
  io::write_file(folder / "link", "two");
  ::close(fd);
  EXPECT_EQ(bytes_of(folder / "log"), "before one two");
  const int read_only = ::open((folder / "log").c_str(), O_RDONLY);
  EXPECT_NE(error_of_writing("/dev/fd/" + std::to_string(read_only)), "");
  ::close(read_only);
  EXPECT_NE(error_of_writing("/dev/fd/" + std::to_string(read_only)), "") << "closed";
}

TEST(OutputFiles, AnAbandonedProgramLeavesNothingAndSaysThatSomeAppeared) {
  for (const bool commits : {false, true}) {
    const TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
      io::OutputFiles files;
      files.add(folder / "a", "new");
      if (commits) files.commit();
      io::OutputFiles later;
      later.add(folder / "b", "new");
      ::_exit(io::abandon_outputs() ? 1 : 0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (commits) {
      EXPECT_EQ(WEXITSTATUS(status), 1);
    }
    EXPECT_EQ(folder.entries(), commits ? 1u : 0u);
  }
}

}  // namespace
}  // namespace aomd::io_output_files_test
