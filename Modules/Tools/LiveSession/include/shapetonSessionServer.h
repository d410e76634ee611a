#ifndef shapetonSessionServer_h
#define shapetonSessionServer_h

#include "ShapetonLiveSessionExport.h"

#include <memory>
#include <string>

namespace shapeton
{
class LiveSession;

/** Settings of SessionServer. \ingroup ShapetonLiveSession */
struct SessionServerSettings
{
  /** IP address to listen on; by default only programs on this machine can connect. */
  std::string address{ "127.0.0.1" };
  /** 0: a free port. */
  unsigned short port{ 0 };
  /** The session ends this many seconds after its last page has been closed; long enough for a reload. */
  double secondsAfterClose{ 10.0 };
  /** The session ends this many seconds after it has lost the connection to its last page, which tries to reconnect.
   * Chosen: longer than most breaks in which a laptop sleeps or has no network, but a forgotten session releases its
   * memory in less than an hour. */
  double secondsAfterLoss{ 1800.0 };
  /** A connection that does not answer is dropped after this time. */
  double secondsOfSilence{ 30.0 };
};

/** \class SessionServer
 * \brief Serves the page of a LiveSession by HTTP and its commands and frames by WebSocket (Boost.Beast).
 *
 * All work is done in the thread of Run(): pieces of the session's work alternate with messages. A message of a page is
 * a JSON command, as for LiveSession::Do(), with three more: {"do": "view", "place": [x, y, z]}, {"do": "ready"}, which
 * requests the next frame, and {"do": "picture", ...}, see LiveSession::Draw(). The server answers each command with
 * {"kind": "answer", ...} or {"kind": "error", "text": ...} and the "id" of the command.
 *
 * Only requests with the secret token of the URL are answered. The header Host must name this machine, which prevents
 * DNS rebinding, and a page of another origin cannot open a WebSocket. Messages are limited to 256 KB; a page receives
 * the next frame only after it has asked for it, so a slow page does not use memory.
 *
 * \ingroup ShapetonLiveSession */
class ShapetonLiveSession_EXPORT SessionServer
{
public:
  /** Opens the port. Throws ParameterError if the address or the port cannot be used. */
  SessionServer(LiveSession & session, const SessionServerSettings & settings);
  ~SessionServer();
  SessionServer(const SessionServer &) = delete;
  SessionServer &
  operator=(const SessionServer &) = delete;

  /** The address of the page, with the token. */
  std::string
  GetUrl() const;

  /** Serves until the last page is closed or lost, a termination signal arrives, or Stop() is called from any thread.
   */
  void
  Run();

  void
  Stop();

private:
  struct Impl;
  std::unique_ptr<Impl> m_Impl;
};
} // namespace shapeton

#endif
