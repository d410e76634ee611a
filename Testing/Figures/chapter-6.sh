# Chapter 6: graphs on surfaces; read by make-figures.
# shellcheck shell=bash

chapter 6 'graphs on surfaces'
write 'Nodes are red, the dual graph is green. `GraphEmbeddingVerifier` verifies each certificate.' ''

# embed NAME GRAPH [OPTIONS...]: embeds and draws a graph.
embed() {
  run GraphEmbedding "$2" "$1.json" --svg "$1.svg" "${@:3}"
  run GraphEmbeddingVerifier "$1.json"
  svg "$1.svg" 1000
}

complete() { # NAME NODES: the complete graph as an edge list
  local edges=() i j
  for ((i = 1; i <= $2; ++i)); do
    for ((j = i + 1; j <= $2; ++j)); do
      edges+=("$i $j")
    done
  done
  lines "$1" "${edges[@]}"
}

figure 6.2 'graphs on surfaces'
lines cube.edges '1 2' '2 3' '3 4' '4 1' '5 6' '6 7' '7 8' '8 5' '1 5' '2 6' '3 7' '4 8'
complete k7.edges 7
complete k8.edges 8
embed cube cube.edges
embed k7 k7.edges
embed k8 k8.edges
panels 1 520 cube.png k7.png k8.png
differs 'Cube on the sphere (genus 0), K7 on the torus (1), K8 on the Poincare disk (2). The printed graphs are not' \
  'given.'

figure 6.3 'K5'
complete k5.edges 5
embed k5-three k5.edges --genus 2
embed k5 k5.edges
panels 1 700 k5-three.png=genus\ 2 k5.png=genus\ 1
differs '**Agrees:** K5 on a surface of genus 2, and of the minimum genus 1.'

figure 6.6 'a planar graph'
lines planar.edges '1 2' '2 3' '3 4' '4 1' '1 5' '2 5' '3 5' '4 5' '2 6' '3 6' '5 6'
embed planar planar.edges
panels 1 700 planar.png
differs 'Stages (a), (c) and (d) for another graph: overlap graph, circles, sphere.'

figure 6.8 'genus one'
lines k33.edges 'a x' 'a y' 'a z' 'b x' 'b y' 'b z' 'c x' 'c y' 'c z'
embed k33 k33.edges
panels 1 700 k33.png
differs 'Ours: K3,3; the printed graph is not given. The flat torus tiles the plane (a); `--surface F.vtp` writes the' \
  'torus in 3D (b).'

figure 6.9 'large graphs'
run SensorNetworkSimulator network --nodes 3000 --steps 1 --range 40
embed network network/step-0000.graphml
panels 1 560 network.png
differs 'Published: 3,000 nodes and 6,000 edges. Ours: a planar network of 3,000 devices. 6.10, genus 1 with 10,000' \
  'nodes, is not drawn: its circles would be too small.'

figure 6.11 'genus two and three'
complete k8.edges 8
complete k9.edges 9
embed k8 k8.edges
embed k9 k9.edges
panels 1 600 k8.png k9.png
differs 'Ours: K8 (genus 2) and K9 (genus 3) in the Poincare disk. The generators of Tables 6.1 to 6.5 are for other' \
  'graphs; the certificate contains ours.'

figure 6.13 'isomorphic graphs'
lines one.edges '1 2' '2 3' '3 4' '4 1' '1 5' '2 5' '3 5' '4 5' '2 6' '3 6' '5 6'
lines other.edges 'c f' 'f a' 'a e' 'e c' 'c b' 'f b' 'a b' 'e b' 'f d' 'a d' 'b d'
run GraphCompare one.edges other.edges same --labels
svg same/comparison.svg 900
panels 1 700 same/comparison.png
differs '**Agrees:** two numberings of a graph, not the printed one, have the same circles in the same colors.'

figure 6.17 'a sensor network'
run SensorNetworkSimulator hours --nodes 150 --steps 5 --range 200 --speed 10
run DynamicGraph hours hours-out --compare 0,4
svg hours-out/steps.svg 1000
svg hours-out/correspondence.svg 1000
panels 1 700 hours-out/steps.png hours-out/correspondence.png
differs 'Ours: five steps of a simulated network. Above: changes since the previous step in green. **Agrees** (below):' \
  'one color per node through all steps.'
