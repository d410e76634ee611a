#ifndef MadeUpTree_h
#define MadeUpTree_h

#include "SourceTree.h"

#include <gtest/gtest.h>

#include <fstream>

namespace rules
{
/** Temporary folder of files written by a test; removed when the test ends. */
class MadeUpTree : public ::testing::Test
{
protected:
  void
  SetUp() override
  {
    const ::testing::TestInfo * test = ::testing::UnitTest::GetInstance()->current_test_info();
    m_Root = std::filesystem::path(SHAPETON_TEST_TEMPORARY_DIR) /
             (std::string("Rules-") + test->test_suite_name() + "-" + test->name());
    std::filesystem::remove_all(m_Root);
    std::filesystem::create_directories(m_Root);
  }

  void
  TearDown() override
  {
    std::filesystem::remove_all(m_Root);
  }

  void
  Write(const std::string & path, const std::string & text) const
  {
    std::filesystem::create_directories((m_Root / path).parent_path());
    std::ofstream stream(m_Root / path, std::ios::binary);
    stream << text;
    ASSERT_TRUE(stream.flush()) << path;
  }

  std::filesystem::path m_Root;
};
} // namespace rules

#endif
