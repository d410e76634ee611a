#ifndef shapetonRemovalAtDeath_h
#define shapetonRemovalAtDeath_h

#include <string>

namespace shapeton
{
/** While it lives, the file (or the empty folder) of this name is removed by the handlers of the signals that end the
 * program. What was made last is removed first. */
class RemovalAtDeath
{
public:
  struct Node;

  /** Installs the handlers. A signal whose handling somebody else has chosen stays as it is: SIGHUP under nohup,
   * SIGSEGV under a sanitizer. */
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

/** While it lives, SIGINT, SIGTERM and their like wait: a program is not killed between two renames. */
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
