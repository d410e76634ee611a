"""A graph on a torus: K7, the complete graph of seven nodes, drawn without crossings.

usage: graph_on_a_torus.py PICTURE.png

Lines with %% start cells for editors that support them.
"""

# %% The graph, embedded and verified
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from shapeton import graphs

picture = sys.argv[1]
graph = graphs.complete_graph(7)
certificate = graphs.embed_graph(graph)
verdict = graphs.verify_embedding(certificate)
print(f"genus {certificate.genus}, {certificate.geometry}; valid: {verdict.is_valid}")

# %% The universal cover of the torus: node circles repeat with both periods
first, second = certificate.periods.reshape(2, 2)
places = certificate.node_positions
shifts = [i * first + j * second for i in range(-2, 3) for j in range(-2, 3)]
colors = plt.get_cmap("tab10").colors
figure, axis = plt.subplots(figsize=(8, 8))
for shift in shifts:
    for node, (place, radius) in enumerate(zip(places, certificate.node_radii)):
        axis.add_patch(plt.Circle(place + shift, radius, color=colors[node], alpha=0.35))
        axis.annotate(str(node), place + shift, ha="center", va="center")

# %% Edges join nodes whose circles touch
everywhere = np.concatenate([places + shift for shift in shifts])
radii = np.tile(certificate.node_radii, len(shifts))
distances = np.linalg.norm(everywhere[:, None] - everywhere[None], axis=2)
touching = np.argwhere(np.triu(np.abs(distances - radii[:, None] - radii[None]) < 1e-6 * radii.max(), 1))
print(f"{len(graph.edges)} edges; each node touches {len(touching) * 2 / len(everywhere):.1f} others in the picture")
for a, b in touching:
    axis.plot(*everywhere[[a, b]].T, color="black", linewidth=0.8)
corners = np.array([0 * first, first, first + second, second, 0 * first]) - 0.5 * (first + second)
axis.plot(*corners.T, color="red")
middle, reach = np.zeros(2), 0.75 * max(np.linalg.norm(first), np.linalg.norm(second))
axis.set(xlim=middle[0] + np.array([-reach, reach]), ylim=middle[1] + np.array([-reach, reach]), aspect="equal")
axis.set_axis_off()
axis.set_title("K7 on a torus: the red parallelogram, opposite sides joined")
figure.savefig(picture, dpi=100)
