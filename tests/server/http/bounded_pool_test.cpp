#include "server/http/bounded_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>

namespace leda::server {
namespace {

TEST(BoundedPool, TakesNoMoreThanMayWait) {
  BoundedPool pool(1, 2);
  std::promise<void> begun, go_on;
  ASSERT_TRUE(pool.take([&] {
    begun.set_value();
    go_on.get_future().wait();
  }));
  begun.get_future().wait();
  std::atomic<int> done{0};
  EXPECT_TRUE(pool.take([&] { ++done; }));
  EXPECT_TRUE(pool.take([&] { ++done; }));
  EXPECT_FALSE(pool.take([&] { ++done; })) << "the third would wait";
  go_on.set_value();
  pool.shutdown();
  EXPECT_EQ(done, 2) << "what waited is done before the end";
}

}  // namespace
}  // namespace leda::server
