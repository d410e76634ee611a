import pickle
import types
import unittest

import numpy as np

import shapeton
from shapeton import graphs

from support import TestCase, needs_tools, run_tool


class GraphTest(TestCase):
    def test_k7_lies_on_the_torus(self):
        certificate = graphs.embed_graph(graphs.complete_graph(7))
        self.assertEqual((certificate.genus, certificate.geometry), (1, "euclidean"))
        self.assertEqual(certificate.node_positions.shape, (7, 2))
        np.testing.assert_allclose(certificate.node_radii, certificate.node_radii[0], rtol=1e-9)
        verdict = graphs.verify_embedding(certificate)
        self.assertTrue(verdict.is_valid, verdict.refusal)
        self.assertEqual(verdict.measures["faces"], 14)

    def test_the_geometry_follows_the_genus(self):
        cube = graphs.embed_graph(graphs.hypercube_graph(3))
        self.assertEqual((cube.genus, cube.geometry), (0, "spherical"))
        np.testing.assert_allclose(np.linalg.norm(cube.node_positions, axis=1), 1.0)
        k8 = graphs.embed_graph(graphs.complete_graph(8))
        self.assertEqual((k8.genus, k8.geometry), (2, "hyperbolic"))
        self.assertEqual(graphs.embed_graph(graphs.hypercube_graph(3), genus=1).genus, 1)

    def test_a_rotation_in_place_of_a_search(self):
        graph, rotation = graphs.torus_grid(5, 4)
        certificate = graphs.embed_graph(graph, rotation=rotation)
        self.assertEqual(certificate.genus, 1)
        self.assertEqual(certificate.rotation, [h for around in rotation for h in around])
        with self.assertRaisesRegex(shapeton.ParameterError, "rotation"):
            graphs.embed_graph(graph, rotation=rotation, genus=1)

    def test_a_graph_keeps_its_edges_and_names(self):
        graph = graphs.Graph(3, [[0, 1], [1, 2]], ["a", "b", "c"])
        np.testing.assert_array_equal(graph.edges, [[0, 1], [1, 2]])
        path = str(self.folder / "graph.graphml")
        graphs.write_graph(graph, path)
        for copy in (graphs.read_graph(path), pickle.loads(pickle.dumps(graph))):
            self.assertEqual(copy.nodes, 3)
            np.testing.assert_array_equal(copy.edges, graph.edges)
            self.assertEqual(copy.names, graph.names)
        with self.assertRaisesRegex(shapeton.InputError, "node 5"):
            graphs.Graph(2, [[0, 5]])
        with self.assertRaisesRegex(shapeton.InputError, "node 4294967296"):
            graphs.Graph(3, [[2**32, 1]])
        for wrong in ([[0.0, 1.5]], [0, 1], [[0, 1, 2]]):
            with self.assertRaisesRegex(shapeton.ParameterError, "edges"):
                graphs.Graph(3, wrong)
        self.assertEqual(graphs.Graph(3, []).edges.shape, (0, 2))

    def test_graphs_of_other_packages(self):
        k4 = graphs.complete_graph(4)
        matrix = np.ones((4, 4)) - np.eye(4)
        sparse = types.SimpleNamespace(tocoo=None, toarray=lambda: matrix)
        for other in (k4.edges.tolist(), k4.edges.astype(np.int16), [tuple(edge) for edge in k4.edges], matrix, sparse):
            np.testing.assert_array_equal(graphs.as_graph(other).edges, k4.edges)
            self.assertEqual(graphs.ricci_curvature(other).edges.tolist(), graphs.ricci_curvature(k4).edges.tolist())
        self.assertTrue(graphs.compare_graphs(matrix, k4).isomorphic)
        self.assertEqual(graphs.as_graph(types.SimpleNamespace(tocoo=None, toarray=lambda: np.array([[0, 1], [1, 0]]))).edges.tolist(), [[0, 1]])
        self.assertEqual(graphs.as_graph(matrix.tolist()).edges.tolist(), k4.edges.tolist())
        self.assertEqual(graphs.as_graph((a, b) for a, b in k4.edges).edges.tolist(), k4.edges.tolist())
        named = graphs.as_graph([("b", "a"), ("a", "c"), ("b", "a")])
        self.assertEqual((named.names, named.edges.tolist()), (["b", "a", "c"], [[0, 1], [1, 2], [0, 1]]))
        with self.assertRaisesRegex(shapeton.InputError, "no nodes"):
            graphs.as_graph([])
        self.assertEqual(graphs.Graph(3).edges.shape, (0, 2))

    def test_graphs_of_networkx(self):
        import networkx

        other = networkx.petersen_graph()
        other.add_node("alone")
        graph = graphs.as_graph(other)
        self.assertEqual((graph.nodes, graph.names[-2:]), (11, ["9", "alone"]))
        self.assertEqual(graph.edges.tolist(), [list(edge) for edge in other.edges])
        self.assertEqual(graphs.embed_graph(networkx.complete_graph(7)).genus, 1)
        double = graphs.as_graph(networkx.MultiGraph([(5, 3), (5, 3), (3, 3)]))
        self.assertEqual((double.names, double.edges.tolist()), (["5", "3"], [[0, 1], [0, 1], [1, 1]]))
        self.assertEqual(graphs.as_graph(networkx.complete_graph(4).edges).edges.tolist(), graphs.complete_graph(4).edges.tolist())
        weighted = networkx.Graph()
        weighted.add_edge("a", "b", weight=2.0)
        for given in (weighted, np.array([[0, 2.0, 0], [2.0, 0, 0], [0, 0, 0]])):
            with self.assertWarnsRegex(UserWarning, "weights of the edges are left out"):
                graphs.as_graph(given)
        with self.assertRaisesRegex(shapeton.InputError, r"directed; use graph.to_undirected\(\)"):
            graphs.ricci_curvature(networkx.DiGraph([(0, 1)]))

    def test_what_is_not_a_graph_is_refused_with_advice(self):
        edges = [[0, 1], [1, 2]]
        with self.assertRaisesRegex(TypeError, r"\"nodes\" must be a whole number, .*use shapeton.graphs.as_graph\(edges\)"):
            graphs.Graph(edges)
        with self.assertRaisesRegex(TypeError, "must be a shapeton.graphs.Graph, not str"):
            graphs.embed_graph("k7")
        with self.assertRaisesRegex(TypeError, "dict is not a graph of networkx"):
            graphs.as_graph({})
        with self.assertRaisesRegex(shapeton.ParameterError, "masked"):
            graphs.as_graph(np.ma.masked_array([[0, 1], [1, 2]], [[False, False], [True, True]]))
        with self.assertRaisesRegex(shapeton.ParameterError, "beyond 2.31 - 2"):
            graphs.as_graph([(0, 2**31)])
        with self.assertRaisesRegex(shapeton.ParameterError, "whole numbers, not <U1"):
            graphs.as_graph(np.array([["a", "b"], ["b", "c"]]))
        with self.assertRaisesRegex(shapeton.ParameterError, "two nodes have the name \"a\""):
            graphs.write_graph(graphs.Graph(2, [[0, 1]], ["a", "a"]), self.folder / "g.graphml")
        self.assertEqual(graphs.as_graph([(1, "1"), ("1", 2)]).names, ["1", "'1'", "2"])
        with self.assertRaisesRegex(shapeton.ParameterError, "5 polygons of 3 sides at a node tile a sphere"):
            graphs.regular_tiling_graph(3, 5, 2)
        for call in (graphs.as_graph, graphs.embed_graph):
            with self.assertRaisesRegex(shapeton.ParameterError, "a pair of nodes; leave out weights"):
                call([(0, 1, 0.5), (1, 2, 0.5), (0, 2, 0.5)])
        with self.assertRaisesRegex(shapeton.ParameterError, "g.gml does not end with .graphml or .xml"):
            graphs.write_graph(graphs.complete_graph(3), self.folder / "g.gml")
        with self.assertRaisesRegex(shapeton.ParameterError, "finite"):
            graphs.as_graph(np.full((3, 3), np.nan))
        with self.assertRaisesRegex(shapeton.ParameterError, "not symmetric"):
            graphs.embed_graph(np.triu(np.ones((4, 4))))

    def test_checked_data_are_read_only(self):
        graph = graphs.complete_graph(5)
        certificate = graphs.embed_graph(graph)
        for view in (graph.edges, certificate.packed.edges, certificate.node_positions, certificate.node_radii):
            with self.assertRaisesRegex(ValueError, "read-only"):
                view[0] = 7

    def test_families_refuse_counts_that_are_none(self):
        self.assertEqual(graphs.hypercube_graph(4).nodes, 16)
        for make, wrong in (
            (graphs.hypercube_graph, (31,)),
            (graphs.hypercube_graph, (-1,)),
            (graphs.hypercube_graph, (40,)),
            (graphs.complete_graph, (-1,)),
            (graphs.grid_graph, (100000, 100000)),
            (graphs.complete_bipartite_graph, (2, -1)),
        ):
            with self.assertRaisesRegex(shapeton.ParameterError, "count of the graph"):
                make(*wrong)
        with self.assertRaisesRegex(shapeton.ParameterError, "fewer rings"):
            graphs.regular_tiling_graph(7, 3, 200)

    def test_isomorphic_graphs_are_found_and_others_told_apart(self):
        k33 = graphs.complete_bipartite_graph(3, 3)
        order = np.array([3, 0, 4, 1, 5, 2])
        same = graphs.compare_graphs(k33, graphs.Graph(6, order[k33.edges]))
        self.assertTrue(same.isomorphic)
        self.assertEqual((same.differences, sorted(same.correspondence)), ([], list(range(6))))
        other = graphs.compare_graphs(k33, graphs.grid_graph(3, 2))
        self.assertFalse(other.isomorphic)
        self.assertTrue(other.differences)

    def test_curvatures_are_exact(self):
        k5 = graphs.ricci_curvature(graphs.complete_graph(5))
        self.assertEqual(set(zip(k5.numerators.tolist(), k5.denominators.tolist())), {(3, 4)})
        np.testing.assert_array_equal(k5.edges, 0.75)
        np.testing.assert_array_equal(k5.triangles, 3)
        np.testing.assert_array_equal(k5.node_sums, 3.0)
        self.assertEqual(set(graphs.ricci_curvature(graphs.hypercube_graph(4), method="linLuYau").edges), {0.5})
        forman = graphs.ricci_curvature(graphs.grid_graph(2, 2), method="forman")
        np.testing.assert_array_equal(forman.node_means, 0.0)
        loop = graphs.ricci_curvature(graphs.Graph(3, [[0, 1], [1, 1]]))
        self.assertEqual(loop.denominators[1], 0)
        self.assertTrue(np.isnan(loop.edges[1]) and np.isnan(loop.node_means[2]))
        for options in ({"idleness": 1.0}, {"method": "forman", "idleness": 0.5}):
            with self.assertRaisesRegex(shapeton.ParameterError, "idleness"):
                graphs.ricci_curvature(graphs.complete_graph(4), **options)

    def test_lattices_have_their_types(self):
        plane = graphs.conformal_type(graphs.regular_tiling_graph(3, 6, 16))
        self.assertEqual((plane.type, plane.root, plane.limit_radius), ("parabolic", 0, (0.0, 0.0)))
        tilings = [graphs.regular_tiling_graph(3, 7, rings) for rings in range(1, 7)]
        disk = graphs.conformal_type(tilings[-1], root=0)
        self.assertEqual(disk.type, "hyperbolic")
        exact = np.arccosh(0.5 / np.sin(np.pi / 7))
        self.assertAlmostEqual(disk.limit_radius[1], exact, delta=1e-3)
        self.assertEqual(disk.packing["type"], disk.resistance["type"])
        np.testing.assert_array_equal(disk.radii, range(1, 7))
        sequence = graphs.conformal_type_of_sequence(tilings, [0] * 6)
        np.testing.assert_allclose(sequence.root_radii, disk.root_radii, rtol=1e-9)
        with self.assertRaisesRegex(shapeton.ParameterError, "must be a node"):
            graphs.conformal_type(tilings[-1], root=-1)
        with self.assertRaisesRegex(shapeton.InputError, "not planar"):
            graphs.conformal_type(graphs.complete_graph(5))
        self.assertEqual(len(graphs.planar_part(graphs.complete_graph(5)).edges), 9)
        with self.assertRaisesRegex(shapeton.ParameterError, "roots"):
            graphs.conformal_type_of_sequence(tilings, [0])

    @needs_tools
    def test_a_certificate_is_that_of_the_tool(self):
        graph = graphs.complete_graph(8)
        path, written = str(self.folder / "graph.graphml"), str(self.folder / "certificate.json")
        graphs.write_graph(graph, path)
        run_tool("GraphEmbedding", path, written)
        again = str(self.folder / "again.json")
        graphs.write_certificate(graphs.embed_graph(graph), again)
        certificate, expected = graphs.read_certificate(again), graphs.read_certificate(written)
        for name in ("node_positions", "node_radii", "face_positions", "face_radii"):
            self.assertSame(getattr(certificate, name), getattr(expected, name))
        self.assertEqual(certificate.statistics, expected.statistics)


if __name__ == "__main__":
    unittest.main()
