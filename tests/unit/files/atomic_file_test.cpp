// Laws of writing: complete or not at all, and a sentence that says why.
#include "files/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "temporary_folder.h"

namespace sturnus {
namespace {

TEST(AtomicFile, WritesTheBytesAndNothingElse) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file(folder / "a.txt", "one\n"));
  ASSERT_TRUE(write_file(folder / "a.txt", "two, longer\n"));
  EXPECT_EQ(read_all(folder / "a.txt"), "two, longer\n");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(AtomicFile, AMissingFolderIsNamed) {
  const TemporaryFolder folder;
  const std::string path = folder / "none/a.txt";
  EXPECT_EQ(write_file(path, "x").error(), path + ": cannot be written: No such file or directory\n");
  EXPECT_TRUE(folder.names().empty());
}

TEST(AtomicFile, AFolderIsNotOverwritten) {
  const TemporaryFolder folder;
  ASSERT_TRUE(make_folders(folder / "b/c/"));
  EXPECT_EQ(write_file(folder / "b", "x").error(), (folder / "b") + ": cannot be written: Is a directory\n");
  EXPECT_FALSE(write_file(folder / "b/", "x"));
  EXPECT_FALSE(write_file("", "x"));
}

TEST(AtomicFile, AFullDiskIsReported) {
  if (::access("/dev/full", W_OK) != 0) GTEST_SKIP() << "no /dev/full here";
  EXPECT_EQ(write_file("/dev/full", "x").error(), "/dev/full: cannot be written: No space left on device\n");
}

TEST(AtomicFile, WhatStoodThereStaysWhenWritingFails) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file(folder / "a.txt", "before"));
  // The name of the unfinished file becomes too long for any file system.
  const std::string long_name(300, 'x');
  EXPECT_FALSE(write_file(folder / long_name, "x"));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(AtomicFile, AFileThatIsCutOffInTheMiddleIsRemoved) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file(folder / "a.txt", "before"));
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{1000, limit.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const Status status = write_file(folder / "a.txt", std::string(5000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(status.error(), (folder / "a.txt") + ": cannot be written: File too large\n");
  EXPECT_EQ(read_all(folder / "a.txt"), "before");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(AtomicFile, ALinkStaysAndItsTargetChanges) {
  const TemporaryFolder folder;
  ASSERT_TRUE(make_folders(folder / "there"));
  ASSERT_TRUE(write_file(folder / "there/target", "before"));
  ASSERT_EQ(::symlink((folder / "there/target").c_str(), (folder / "link").c_str()), 0);
  ASSERT_TRUE(write_file(folder / "link", "after"));
  EXPECT_EQ(read_all(folder / "there/target"), "after");
  struct stat info {};
  ASSERT_EQ(::lstat((folder / "link").c_str(), &info), 0);
  EXPECT_TRUE(S_ISLNK(info.st_mode));
}

TEST(AtomicFile, PermissionsSurvive) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file(folder / "a", "x"));
  ASSERT_EQ(::chmod((folder / "a").c_str(), 0600), 0);
  ASSERT_TRUE(write_file(folder / "a", "y"));
  struct stat info {};
  ASSERT_EQ(::stat((folder / "a").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0600u);
}

TEST(AtomicFile, ADescriptorIsWrittenWhereItStands) {
  const TemporaryFolder folder;
  std::FILE* file = std::fopen((folder / "stream").c_str(), "wb");
  ASSERT_NE(file, nullptr);
  std::fputs("first,", file);
  std::fflush(file);
  ASSERT_TRUE(write_file("/dev/fd/" + std::to_string(::fileno(file)), "second"));
  std::fclose(file);
  EXPECT_EQ(read_all(folder / "stream"), "first,second");
}

TEST(AtomicFile, FoldersAreMadeOrRefused) {
  const TemporaryFolder folder;
  EXPECT_TRUE(make_folders(folder / "x/y/z"));
  EXPECT_TRUE(make_folders(folder / "x/y/z"));
  EXPECT_TRUE(make_folders(""));
  ASSERT_TRUE(write_file(folder / "file", "x"));
  EXPECT_FALSE(make_folders(folder / "file"));
  EXPECT_FALSE(make_folders(folder / "file/below"));
}

}  // namespace
}  // namespace sturnus
