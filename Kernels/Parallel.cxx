#include "Parallel.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace rtg
{

namespace
{

// A loop that is running, on the stack of the thread that called ParallelFor().
struct Loop
{
  const std::function<void(std::size_t)>& work;
  const std::size_t count;
  std::atomic<std::size_t> next;
  std::size_t helpers;      // pool threads inside it; guarded by the pool's mutex
  std::exception_ptr error; // likewise
};

class Pool
{
public:
  // It is never destroyed: its threads sleep when the process ends.
  static Pool& Get()
  {
    static Pool& pool = *new Pool;
    return pool;
  }

  void For(std::size_t count, const std::function<void(std::size_t)>& work)
  {
    const std::size_t threads = std::min(count, this->threadCount.load());
    if (threads < 2)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        work(i);
      }
      return;
    }
    Loop loop{ work, count, 0, 0, nullptr };
    {
      const std::lock_guard<std::mutex> lock(this->mutex_);
      this->MakeWorkers();
      this->open_.push_back(&loop);
    }
    for (std::size_t i = 1; i < threads; ++i)
    {
      this->wake_.notify_one();
    }
    this->Run(loop);
    std::unique_lock<std::mutex> lock(this->mutex_);
    this->Close(loop);
    this->left_.wait(lock, [&loop] { return loop.helpers == 0; });
    if (loop.error)
    {
      std::rethrow_exception(loop.error);
    }
  }

  std::atomic<std::size_t> threadCount{ std::max(1u, std::thread::hardware_concurrency()) };

private:
  // Fewer when the system gives no more; the loop then takes longer.
  void MakeWorkers()
  {
    try
    {
      for (; this->workers_ + 1 < this->threadCount; ++this->workers_)
      {
        std::thread([this] { this->Work(); }).detach();
      }
    }
    catch (const std::system_error&)
    {
    }
  }

  // Takes part in the innermost loop there is: those further out wait for it.
  void Work()
  {
    std::unique_lock<std::mutex> lock(this->mutex_);
    for (;;)
    {
      const auto joinable = [this]
      {
        return std::find_if(this->open_.rbegin(), this->open_.rend(),
          [this](const Loop* loop) { return loop->helpers + 1 < this->threadCount; });
      };
      this->wake_.wait(lock, [&] { return joinable() != this->open_.rend(); });
      Loop& loop = **joinable();
      ++loop.helpers;
      lock.unlock();
      this->Run(loop);
      lock.lock();
      this->Close(loop);
      if (--loop.helpers == 0)
      {
        this->left_.notify_all();
      }
    }
  }

  void Run(Loop& loop)
  {
    try
    {
      for (std::size_t i = loop.next++; i < loop.count; i = loop.next++)
      {
        loop.work(i);
      }
    }
    catch (...)
    {
      loop.next = loop.count;
      const std::lock_guard<std::mutex> lock(this->mutex_);
      loop.error = loop.error ? loop.error : std::current_exception();
    }
  }

  // Closed: no thread may join. The mutex is held.
  void Close(Loop& loop)
  {
    this->open_.erase(std::remove(this->open_.begin(), this->open_.end(), &loop), this->open_.end());
  }

  std::mutex mutex_;
  std::condition_variable wake_, left_;
  std::deque<Loop*> open_; // loops that may be joined, innermost last
  std::size_t workers_ = 0;
};

} // namespace

void SetThreadCount(std::size_t count)
{
  Pool::Get().threadCount = std::max<std::size_t>(1, count);
}

std::size_t ThreadCount()
{
  return Pool::Get().threadCount;
}

void ParallelFor(std::size_t count, const std::function<void(std::size_t)>& work)
{
  Pool::Get().For(count, work);
}

} // namespace rtg
