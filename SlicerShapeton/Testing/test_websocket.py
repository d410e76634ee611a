"""The WebSocket client against a server of the test, which sends what a real one seldom does. test_livesession.py uses the
real one."""

import base64
import hashlib
import os
import socket
import struct
import time
import unittest

from case import hangingSeconds, numberOfWaits, waitFor

from ShapetonLib.websocket import ConnectionLost, WebSocket


class WebSocketTest(unittest.TestCase):
    def setUp(self):
        listener = socket.create_server(("127.0.0.1", 0))
        self.port = listener.getsockname()[1]
        self.client = WebSocket(f"http://127.0.0.1:{self.port}/token/live")
        self.server, _ = listener.accept()
        listener.close()
        self.server.settimeout(hangingSeconds)
        self.addCleanup(self.server.close)
        self.addCleanup(self.client.close)

    def shakeHands(self, status="101 Switching Protocols", change=lambda proof: proof):
        self.client.poll()
        self.request = self.server.recv(4096).decode()
        key = self.request.split("Sec-WebSocket-Key: ")[1].split("\r\n")[0]
        proof = hashlib.sha1((key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11").encode()).digest()
        accept = change(base64.b64encode(proof).decode())
        self.server.sendall(f"HTTP/1.1 {status}\r\nsec-websocket-ACCEPT: {accept}\r\n\r\n".encode())

    def sendFrame(self, head, payload, size=None):
        length = len(payload)
        size = size or (struct.pack("!B", length) if length < 126 else struct.pack("!BQ", 127, length))
        self.server.sendall(bytes([head]) + size + payload)

    def receive(self, number=1):
        messages = []
        waitFor(lambda: len(messages) >= number, lambda: messages.extend(self.client.poll()))
        return messages

    def sent(self):
        """The opcode and the payload of a frame of the client."""
        head, length = self.server.recv(2)
        self.assertTrue(length & 0x80)  # masked
        length &= 0x7F
        if length >= 126:
            length = int.from_bytes(self.server.recv(2 if length == 126 else 8), "big")
        mask = self.server.recv(4)
        payload = b""
        while len(payload) < length:
            self.client.poll()  # sends what the socket has not taken
            payload += self.server.recv(length - len(payload))
        return head & 0x0F, bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload))

    def testTheRequestNamesHostAndOrigin(self):
        self.shakeHands()
        self.assertIn(f"GET /token/live HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\n", self.request)
        self.assertIn(f"Origin: http://127.0.0.1:{self.port}\r\n", self.request)

    def testMessagesWaitForTheHandshake(self):
        self.client.send("early")
        self.shakeHands()
        self.assertTrue(self.request.endswith("\r\n\r\n"))
        self.receive(0)
        self.client.poll()
        self.assertEqual(self.sent(), (1, b"early"))

    def testMessagesOfAllLengthsArriveBothWays(self):
        self.shakeHands()
        for length in (0, 1, 125, 126, 65535, 65536, 3000000):
            payload = os.urandom(length)
            self.client.send(payload.hex())
            self.client.poll()
            self.assertEqual(self.sent(), (1, payload.hex().encode()))
        for length in (0, 1, 125):
            self.sendFrame(0x82, bytes(length))
        self.assertEqual([len(message) for message in self.receive(3)], [0, 1, 125])
        self.sendFrame(0x82, b"abc" * 42, struct.pack("!BH", 126, 126))
        self.assertEqual(self.receive(), [b"abc" * 42])

    def testFragmentsAreJoinedAndPingsAnswered(self):
        self.shakeHands()
        self.sendFrame(0x01, b"a\xc3")
        self.sendFrame(0x89, b"are you there")
        self.sendFrame(0x80, b"\xa4b")
        self.assertEqual(self.receive(), ["aäb"])
        self.client.poll()
        self.assertEqual(self.sent(), (10, b"are you there"))

    def testAPieceOfAMessageDoesNotBlock(self):
        self.shakeHands()
        self.server.sendall(b"\x81\x05ab")
        waits = numberOfWaits()
        self.assertEqual(self.client.poll(), [])
        self.assertEqual(numberOfWaits(), waits)
        self.server.sendall(b"cde")
        self.assertEqual(self.receive(), ["abcde"])

    def testWrongAnswersAreErrors(self):
        for message, act in (
            ("rejected .*403", lambda: self.shakeHands("403 Forbidden")),
            ("rejected", lambda: self.shakeHands(change=lambda proof: "x" + proof)),
            ("malformed answer", lambda: self.server.sendall(b"x" * 10000)),
            ("malformed message", lambda: (self.shakeHands(), self.sendFrame(0xC1, b""))),
            ("malformed message", lambda: (self.shakeHands(), self.server.sendall(b"\x81\x80"))),
            ("too long", lambda: (self.shakeHands(), self.server.sendall(b"\x82" + struct.pack("!BQ", 127, 1 << 40)))),
            ("has ended", lambda: (self.shakeHands(), self.sendFrame(0x88, b"\x03\xe9"))),
            ("was closed", lambda: (self.shakeHands(), self.server.close())),
        ):
            with self.subTest(message), self.assertRaisesRegex(ConnectionLost, message):
                self.setUp()
                act()
                self.receive()

    def testNobodyListens(self):
        self.server.close()
        client = WebSocket(f"http://127.0.0.1:{self.port}/")
        self.addCleanup(client.close)
        with self.assertRaisesRegex(ConnectionLost, "lost: .*refused"):
            for _ in range(100):
                client.poll()
                time.sleep(0.01)

    def testSilenceIsAnError(self):
        self.shakeHands()
        self.receive(0)
        self.client.secondsOfSilence = 0.05
        time.sleep(0.1)
        with self.assertRaisesRegex(ConnectionLost, "no answer"):
            self.client.poll()
            time.sleep(0.1)
            self.client.poll()


if __name__ == "__main__":
    unittest.main()
