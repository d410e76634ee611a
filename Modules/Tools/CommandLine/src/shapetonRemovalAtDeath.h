#ifndef shapetonRemovalAtDeath_h
#define shapetonRemovalAtDeath_h

#include <string>

namespace shapeton
{
/** RAII guard: while it exists, the handlers of termination signals remove the named file or empty folder. The latest
 * guard is processed first. */
class RemovalAtDeath
{
public:
  struct Node;

  /** Installs the handlers. Signals that are already handled or ignored are not changed: SIGHUP under nohup, SIGSEGV
   * under a sanitizer. */
  static void
  InstallHandlers();

  explicit RemovalAtDeath(const std::string & path);
  RemovalAtDeath(RemovalAtDeath && other) noexcept;
  RemovalAtDeath &
  operator=(RemovalAtDeath &&) = delete;
  ~RemovalAtDeath();

private:
  Node * m_Node;
};

/** RAII guard that defers SIGINT, SIGTERM and similar signals, to avoid termination between two renames. */
class DeathDelay
{
public:
  DeathDelay();
  DeathDelay(const DeathDelay &) = delete;
  DeathDelay &
  operator=(const DeathDelay &) = delete;
  ~DeathDelay();
};
} // namespace shapeton

#endif
