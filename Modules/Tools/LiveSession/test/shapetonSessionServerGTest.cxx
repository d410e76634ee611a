#include "shapetonExceptions.h"
#include "shapetonRandomCommands.h"
#include "shapetonSessionClient.h"
#include "shapetonSessionServer.h"
#include "shapetonSessionTestVolume.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <random>
#include <thread>

namespace
{
using basetest::SessionClient;
using shapeton::Json;

/** A server in another thread, stopped at the end. */
class Served
{
public:
  explicit Served(const shapeton::SessionServerSettings & settings = {})
    : m_Session(input.Volume(), input.Settings())
    , m_Server(m_Session, settings)
    , url(m_Server.GetUrl())
    , m_Thread([this] { m_Server.Run(); })
  {}
  ~Served()
  {
    m_Server.Stop();
    this->Join();
  }

  /** Waits until the server has ended by itself. */
  void
  Join()
  {
    if (m_Thread.joinable())
    {
      m_Thread.join();
    }
  }

  basetest::SessionInput input;

private:
  shapeton::LiveSession   m_Session;
  shapeton::SessionServer m_Server;

public:
  const basetest::SessionUrl url;

private:
  std::thread m_Thread;
};

/** The status with which the server answers a request for the page. */
unsigned int
StatusOf(const Served & served, const std::string & target, const std::string & host, const std::string & origin = "")
{
  return basetest::Get(served.url, target, host, origin).result_int();
}

/** Whether the server accepts a WebSocket. */
bool
Accepts(const Served & served, const std::string & target, const std::string & host, const std::string & origin)
{
  try
  {
    SessionClient client(served.url, target, host, origin);
    return client.Ask(R"({"do": "pause", "id": 1})")["done"] == "pause";
  }
  catch (const boost::system::system_error &)
  {
    return false;
  }
}

TEST(SessionServer, ListensOnThisMachineWithARandomToken)
{
  const Served first;
  const Served second;
  EXPECT_EQ(first.url.address, "127.0.0.1");
  EXPECT_EQ(first.url.token.size(), 32U);
  EXPECT_NE(first.url.token, second.url.token);
  const auto page = basetest::Get(first.url, "/" + first.url.token + "/", first.url.Host());
  EXPECT_EQ(page.result_int(), 200U);
  EXPECT_NE(page.body().find("startSession("), std::string::npos);
  EXPECT_NE(page.body().find("connect-src ws://" + first.url.Host()), std::string::npos);
  EXPECT_EQ(page["Referrer-Policy"], "no-referrer");
  EXPECT_EQ(page["X-Frame-Options"], "DENY");
}

TEST(SessionServer, RejectsAWrongTokenHostOriginOrMethod)
{
  const Served      served;
  const std::string token = served.url.token;
  const std::string host = served.url.Host();
  std::string       wrong = token;
  wrong[5] = wrong[5] == 'a' ? 'b' : 'a';
  EXPECT_EQ(StatusOf(served, "/", host), 403U);
  EXPECT_EQ(StatusOf(served, "/" + wrong + "/", host), 403U);
  EXPECT_EQ(StatusOf(served, "/" + token.substr(1) + "/", host), 403U);
  EXPECT_EQ(StatusOf(served, "/" + token + "0/", host), 403U);
  EXPECT_EQ(StatusOf(served, "/" + token + "/../../etc/passwd", host), 404U);
  EXPECT_EQ(StatusOf(served, "/" + token + "/", "evil.example:" + served.url.port), 421U);
  EXPECT_EQ(StatusOf(served, "/" + token + "/", "127.0.0.1.evil.example"), 421U);
  EXPECT_EQ(StatusOf(served, "/" + token + "/", ""), 421U);
  EXPECT_EQ(StatusOf(served, "/" + token + "/", host, "http://evil.example"), 403U);
  EXPECT_EQ(basetest::Get(served.url, "/" + token + "/", host, "", boost::beast::http::verb::post).result_int(), 405U);
  // Through a tunnel, the port is different.
  EXPECT_EQ(StatusOf(served, "/" + token + "/", "localhost:9000"), 200U);

  const std::string live = "/" + token + "/live";
  EXPECT_TRUE(Accepts(served, live, host, "http://" + host));
  EXPECT_TRUE(Accepts(served, live, "localhost:9000", "http://localhost:9000"));
  EXPECT_FALSE(Accepts(served, "/" + wrong + "/live", host, "http://" + host));
  EXPECT_FALSE(Accepts(served, live, host, "http://evil.example"));
  EXPECT_FALSE(Accepts(served, live, host, "https://" + host));
  EXPECT_FALSE(Accepts(served, live, host, "null"));
  EXPECT_FALSE(Accepts(served, live, host, "http://localhost:" + served.url.port));
  EXPECT_FALSE(Accepts(served, live, "evil.example", "http://evil.example"));
  EXPECT_FALSE(Accepts(served, "/live", host, "http://" + host));
}

TEST(SessionServer, RejectsAnUnusableAddress)
{
  const basetest::SessionInput    input;
  shapeton::LiveSession           session(input.Volume(), input.Settings());
  shapeton::SessionServerSettings settings;
  for (const char * address : { "everywhere", "0.0.0.0", "::" })
  {
    settings.address = address;
    EXPECT_THROW(shapeton::SessionServer(session, settings), shapeton::ParameterError) << address;
  }
}

TEST(SessionServer, SendsFramesAndObeys)
{
  Served        served;
  SessionClient client(served.url);
  const auto    moved = client.Await([](const Json & frame) { return frame["state"]["step"] == 60; });
  EXPECT_EQ(moved["state"]["isMoving"], false);
  EXPECT_EQ(client.Ask(R"({"do": "set", "p": 11, "id": 42})")["id"], 42);
  client.Await([](const Json & frame) { return frame["state"]["options"]["p"] == 11 && frame["state"]["step"] == 60; });
  client.Ask(R"({"do": "heat", "timeSteps": 700})");
  client.Await([](const Json & frame) { return frame["state"]["quality"] == "exact"; });
  EXPECT_EQ(client.Ask(R"({"do": "view", "place": [1, 2, 3]})")["done"], "view");
  const auto view = client.Await([](const Json & frame) { return frame.contains("slices"); });
  EXPECT_EQ(view["slices"][2]["index"], 3);
  const auto saved = client.Ask(R"({"do": "save", "name": "mine"})");
  EXPECT_EQ(saved["files"].size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(served.input.GetFolder() / "mine-heat.nrrd"));
}

TEST(SessionServer, AnswersWrongMessagesWithAnError)
{
  Served        served;
  SessionClient client(served.url);
  for (const std::string message : { "",
                                     "{",
                                     "[1, 2",
                                     "\xff\xfe",
                                     "null",
                                     "[]",
                                     "{\"do\": \"set\"}",
                                     "{\"do\": []}",
                                     "{\"do\": \"view\", \"place\": [1, 2]}",
                                     "{\"do\": \"view\", \"place\": \"x\"}",
                                     "{\"do\": \"picture\"}",
                                     "{\"do\": \"save\", \"name\": \"../x\"}",
                                     "{\"do\": \"start\", \"region\": \"file\", \"name\": \"/etc/passwd\"}" })
  {
    if (message != "\xff\xfe") // a text message must be UTF-8; see below
    {
      EXPECT_EQ(client.Ask(message)["kind"], "error") << message;
    }
  }
  EXPECT_EQ(client.Ask(std::string(100000, '['))["kind"], "error");
  SessionClient other(served.url);
  EXPECT_THROW(other.Ask("\xff\xfe"), boost::system::system_error);
  EXPECT_EQ(client.Ask(R"({"do": "pause"})")["done"], "pause");
}

TEST(SessionServer, DropsAHugeMessage)
{
  Served        served;
  SessionClient huge(served.url);
  EXPECT_THROW(huge.Ask(std::string(1 << 20, ' ')), boost::system::system_error);
  SessionClient client(served.url);
  EXPECT_EQ(client.Ask(R"({"do": "pause"})")["done"], "pause");
}

TEST(SessionServer, ReadsAndWritesOnlyInItsFolder)
{
  Served            served;
  SessionClient     client(served.url);
  const std::string folder = served.input.GetFolder() / "";
  std::filesystem::create_directory_symlink("/", folder + "root");
  std::filesystem::create_symlink("/etc/hostname", folder + "a.sh");
  client.Await([](const Json & frame) { return frame["state"]["step"] == 60; });
  for (const std::string name : { "../input.nrrd",
                                  "/etc/passwd",
                                  "root/etc/passwd",
                                  "./input.nrrd",
                                  "a/../input.nrrd",
                                  "",
                                  ".",
                                  "..",
                                  "a\\u0000b",
                                  "a.sh" })
  {
    EXPECT_EQ(client.Ask(R"({"do": "start", "region": "file", "name": ")" + name + "\"}")["kind"], "error") << name;
  }
  for (const std::string name :
       { "../a", "/tmp/a", "root/tmp/a", "", ".", "..", "a\\u0000b", "a b", "$(id)", "a/b", "-a" })
  {
    EXPECT_EQ(client.Ask(R"({"do": "save", "name": ")" + name + "\"}")["kind"], "error") << name;
  }
  // The script would replace the target of a link.
  EXPECT_EQ(client.Ask(R"({"do": "save", "name": "a"})")["kind"], "error");
  EXPECT_EQ(client.Ask(R"({"do": "start", "region": "file", "name": "input.nrrd"})")["done"], "start");
}

TEST(SessionServer, TwoPagesSeeTheSameSession)
{
  Served        served;
  SessionClient first(served.url);
  SessionClient second(served.url);
  first.Ask(R"({"do": "set", "seed": 77})");
  const auto isDone = [](const Json & frame) {
    return frame["state"]["options"]["seed"] == 77 && frame["state"]["step"] == 60;
  };
  second.Await(isDone);
  first.Await(isDone);
  second.Ask(R"({"do": "step", "steps": 5})");
  first.Await([](const Json & frame) { return frame["state"]["step"] == 65; });
}

TEST(SessionServer, DeadPagesDoNotStopIt)
{
  shapeton::SessionServerSettings settings;
  settings.secondsOfSilence = 0.5;
  Served served(settings);
  {
    SessionClient killed(served.url);
    killed.Send(R"({"do": "ready"})");
    killed.GetSocket().set_option(boost::asio::socket_base::linger(true, 0)); // the close is a reset
  }
  SessionClient dead(served.url); // does not read
  for (int i = 0; i < 20; ++i)
  {
    dead.Send(R"({"do": "ready"})");
    dead.Send(R"({"do": "step", "steps": 3})");
  }
  SessionClient client(served.url);
  client.Await([](const Json & frame) { return frame["state"]["step"] >= 60; });
  EXPECT_EQ(client.Ask(R"({"do": "pause"})")["done"], "pause");
  // An incomplete request, and a connection without any request.
  boost::asio::io_context      context;
  boost::asio::ip::tcp::socket half(context);
  half.connect(
    { boost::asio::ip::make_address(served.url.address), static_cast<unsigned short>(std::stoi(served.url.port)) });
  boost::asio::write(half, boost::asio::buffer(std::string("GET / HT")));
  std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  boost::system::error_code error;
  char                      byte = 0;
  half.read_some(boost::asio::buffer(&byte, 1), error);
  EXPECT_TRUE(error); // closed by the server
  SessionClient next(served.url);
  EXPECT_EQ(next.Ask(R"({"do": "pause"})")["done"], "pause");
}

TEST(SessionServer, EndsAfterItsLastPage)
{
  constexpr double soon = 0.3; // s
  for (const bool isClosed : { false, true })
  {
    shapeton::SessionServerSettings settings;
    (isClosed ? settings.secondsAfterClose : settings.secondsAfterLoss) = soon;
    Served served(settings);
    std::this_thread::sleep_for(std::chrono::milliseconds(600)); // it waits for the first page
    {
      SessionClient client(served.url);
      EXPECT_EQ(client.Ask(R"({"do": "heat", "timeSteps": 1000000})")["done"], "heat");
      if (isClosed)
      {
        client.Close();
      }
    }
    served.Join();
    EXPECT_THROW(SessionClient again(served.url), boost::system::system_error);
  }
}

TEST(SessionServer, WaitsForAPageThatLostItsConnection)
{
  shapeton::SessionServerSettings settings;
  settings.secondsAfterClose = 0.1;
  Served served(settings);
  {
    SessionClient lost(served.url);
    EXPECT_EQ(lost.Ask(R"({"do": "set", "p": 11})")["done"], "set");
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  SessionClient again(served.url);
  const auto    frame = again.Await([](const Json & one) { return one["state"]["step"] == 60; });
  EXPECT_EQ(frame["state"]["options"]["p"], 11);
}

/** Resident memory of this process in MB. */
double
ResidentMemory()
{
  constexpr double pagesPerMB = 256.0; // of 4096 bytes
  std::ifstream    file("/proc/self/statm");
  double           total = 0.0;
  double           resident = 0.0;
  file >> total >> resident;
  return resident / pagesPerMB;
}

/** Sends random messages for a while, like a page that is closed and reopened now and then. */
class RandomPage
{
public:
  RandomPage(const Served & served, unsigned int seed) : m_Served(served), m_Random(seed) {}

  /** Returns the number of messages. */
  int
  Run(double seconds)
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    int        messages = 0;
    for (; std::chrono::steady_clock::now() < end; ++messages)
    {
      if (!m_Client || m_Random() % 100 == 0)
      {
        m_Client = std::make_unique<SessionClient>(m_Served.url);
      }
      this->SendOne();
    }
    return messages;
  }

private:
  void
  SendOne()
  {
    switch (m_Random() % 8)
    {
      case 0:
        EXPECT_TRUE(m_Client->Ask(basetest::RandomMessage(m_Random)).contains("kind"));
        break;
      case 1:
        EXPECT_EQ(m_Client->Ask(m_Random() % 2 ? R"({"do": "view", "whole": true})"
                                               : R"({"do": "view", "whole": false})")["done"],
                  "view");
        break;
      case 2:
        m_Client->Ask(R"({"do": "picture", "azimuth": 30, "elevation": 20, "zoom": 1, "width": 64, "height": 64,
          "quality": 80, "lines": [{"lower": 0.1, "upper": 1, "color": "#ff0000", "opacity": 1}]})");
        break;
      case 3:
        m_Client->Send(R"({"do": "ready"})"); // the frame comes before one of the next answers
        break;
      case 4:
        basetest::Get(m_Served.url, "/" + m_Served.url.token.substr(m_Random() % 3) + "/", m_Served.url.Host());
        break;
      default:
        m_Client->Ask(basetest::RandomCommand(m_Random));
    }
  }

  const Served &                 m_Served;
  std::mt19937                   m_Random;
  std::unique_ptr<SessionClient> m_Client;
};

/** SHAPETON_RANDOM_SECONDS is the duration, by default 20 s. The first tenth fills caches. */
TEST(SessionServer, SurvivesRandomCommandsWithoutGrowth)
{
  const char * const given = std::getenv("SHAPETON_RANDOM_SECONDS");
  const double       seconds = given ? std::stod(given) : 20.0;
  Served             served;
  RandomPage         page(served, 62);
  int                messages = page.Run(seconds / 10.0);
  const double       start = ResidentMemory();
  messages += page.Run(0.45 * seconds);
  const double middle = ResidentMemory();
  messages += page.Run(0.45 * seconds);
  const double end = ResidentMemory();
  std::cout << messages << " messages; resident memory at start, middle, end: " << start << ", " << middle << ", "
            << end << " MB" << std::endl;
  constexpr double most = 64.0; // MB; the script grows by a line for each change
  EXPECT_LT(end - start, most);
  SessionClient client(served.url);
  EXPECT_EQ(client.Ask(R"({"do": "pause"})")["done"], "pause");
}
} // namespace
