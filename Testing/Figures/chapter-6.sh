# Chapter 6: graphs on surfaces; read by make-figures.
# shellcheck shell=bash disable=SC2016

chapter 6 'graphs on surfaces'
write 'Nodes are red, the dual graph is green. `GraphEmbeddingVerifier` verifies each certificate. The printed graphs are not' \
  'given; where possible, ours are real.' ''

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

figure 6.1 'a graph on the torus'
needs graphs/rome/grafo4950.50.graphml
embed rome-1 grafo4950.50.graphml
panels 1 700 rome-1.png
differs 'A Rome graph of genus 1 on the flat torus, which tiles the plane. **Agrees:** no edges cross. (b), the torus in space,' \
  'is not drawn; `--surface F.vtp` writes it.'

figure 6.2 'graphs on surfaces'
needs graphs/power/case118.m graphs/rome/grafo4950.50.graphml graphs/karate.gml graphs/rome/grafo8229.70.graphml
embed power case118.m
embed rome-1 grafo4950.50.graphml
embed karate karate.gml
embed rome-3 grafo8229.70.graphml
panels 2 360 "power.png@0,500,1000,500=(a) power grid of 118 buses, genus 0" "rome-1.png=(b) Rome graph of 50 nodes, genus 1" \
  "karate.png=(c) karate club of 34 members, genus 2" "rome-3.png=(d) Rome graph of 70 nodes, genus 3"
differs '**Differs:** (c) is shown in the Poincare disk, not in space.'

figure 6.3 'K5'
complete k5.edges 5
embed k5-three k5.edges --genus 2
embed k5 k5.edges
panels 1 700 k5-three.png=genus\ 2 k5.png=genus\ 1
differs '**Agrees:** K5 on a surface of genus 2, and of the minimum genus 1.'

figure 6.4 'the universal cover of genus two'
needs graphs/karate.gml
embed karate karate.gml
panels 1 700 karate.png
differs 'The karate club. Each color is a copy of the fundamental domain, as published; the certificate contains our' \
  'generators.'

figure 6.5 'stages of an embedding'
needs graphs/karate.gml
embed karate karate.gml
run GraphEmbedding karate.gml karate-space.json --surface karate.vtp
run SurfaceColors karate.vtp karate-space.png curves=karate.vtp width=0.01 azimuth=20 elevation=50
panels 3 300 "karate.png@0,0,500,500=graph and dual on a surface of genus 2" "karate.png@500,0,500,500=Ricci flow, in the plane" \
  "karate-space.png=in space"
differs 'The karate club. **Agrees:** the three stages.'

figure 6.6 'stages for a planar graph'
lines planar.edges '1 2' '2 3' '3 4' '4 1' '1 5' '2 5' '3 5' '4 5' '2 6' '3 6' '5 6'
embed planar planar.edges
embed planar-edge-node planar.edges --infinity edgeNode
panels 2 350 "planar.png@0,0,500,500=(a) graph and dual" "planar-edge-node.png@0,0,500,500=(b) reduced graph: an edge node at infinity" \
  "planar-edge-node.png@500,0,500,500=(c) result of the flow" "planar.png@0,500,500,500=(d) sphere"
differs 'Another graph. **Agrees:** (c) the circles around the edge node at infinity become the sides of a rectangle.'

figure 6.8 'genus one'
lines k33.edges 'a x' 'a y' 'a z' 'b x' 'b y' 'b z' 'c x' 'c y' 'c z'
embed k33 k33.edges
panels 1 700 k33.png
differs 'K3,3. The flat torus tiles the plane (a); `--surface F.vtp` writes the torus in 3D (b).'

figure 6.9 'a large planar graph'
needs graphs/3elt.graph
embed elements 3elt.graph
panels 2 430 "elements.png@0,0,1000,500" "elements.png@0,500,1000,500"
differs 'Published: 3,000 nodes, 6,000 edges, 28 s. Ours: 4,720 nodes and 13,722 edges, 0.7 s with two cores. **Agrees:** (a)' \
  'to (d): plane, graph and dual graph, circles, sphere. Circles shrink around the holes of the mesh.'

figure 6.10 'a large graph of genus one'
into grid.edges awk 'BEGIN { for (i = 0; i < 100; ++i) for (j = 0; j < 100; ++j) { k = 100 * i + j
  if ((i + 2 * j) % 5) print k, 100 * ((i + 1) % 100) + j
  print k, 100 * i + (j + 1) % 100 } }'
embed grid grid.edges
panels 1 400 grid.png@0,0,500,500
differs 'A grid of 10,000 nodes and 18,000 edges.'

figure 6.12 'genus two and three'
needs graphs/rome/grafo3309.59.graphml graphs/rome/grafo3854.46.graphml graphs/rome/grafo8229.70.graphml \
  graphs/rome/grafo9330.69.graphml
four=()
for graph in 3309.59=2 3854.46=2 8229.70=3 9330.69=3; do
  name=${graph%=*}
  embed "rome-$name" "grafo$name.graphml"
  four+=("rome-$name.png@500,0,500,500=Rome graph $name, genus ${graph#*=}")
done
panels 2 300 "${four[@]}"
differs '**Agrees:** colored domains tile the disk. Tables 6.1 to 6.5 are for other graphs.'

figure 6.13 'isomorphic graphs'
lines one.edges '1 2' '2 3' '3 4' '4 1' '1 5' '2 5' '3 5' '4 5' '2 6' '3 6' '5 6'
lines other.edges 'c f' 'f a' 'a e' 'e c' 'c b' 'f b' 'a b' 'e b' 'f d' 'a d' 'b d'
run GraphCompare one.edges other.edges same --labels
svg same/comparison.svg 1200
for graph in one other; do
  run circle-layout.py $graph.edges $graph.svg
  svg $graph.svg 400
done
panels 2 400 "one.png=(a) a graph" "other.png=(b) the same graph, numbered anew" "same/comparison.png@0,0,600,600=(c)" \
  "same/comparison.png@600,0,600,600=(d)"
differs '**Agrees:** both have the same circles (c, d). Ours is not the printed graph.'

# branches EXPRESSIONS [WITHOUT]: an awk program that prints two expressions of the ends $1 and $2 of each branch of a MATPOWER case,
# excluding the branches with the given numbers.
branches() {
  printf '/^mpc.branch/ { inside = 1; next } /^\\];/ { inside = 0 } inside && index(" %s ", " " ++n " ") == 0 { print %s }' "${2-}" "$1"
}

figure 6.14 'isomorphic graphs of real data'
needs graphs/power/case118.m
into anew.edges awk "$(branches '$1 * 37 % 119, $2 * 37 % 119')" case118.m # 37 and 119 have no common divisor: all differ
run GraphCompare case118.m anew.edges power-twice
svg power-twice/comparison.svg 900
panels 1 720 power-twice/comparison.png
differs 'Published: part of a graph of e-mails. Ours: the power grid of 118 buses with two numberings. **Agrees:** the pictures' \
  'are equal, and partners have one color.'

figure 6.15 'a small graph that changes'
ring=('1 2' '2 3' '3 4' '4 5' '5 6' '6 1' '7 1' '7 2' '7 3' '8 3' '8 4' '8 5' '9 5' '9 6' '9 1' '7 8' '8 9' '9 7')
lines small/step-0.edges "${ring[@]}"
lines small/step-1.edges "${ring[@]}" '10 1' '10 2' '10 7'
lines small/step-2.edges "${ring[@]}" '10 1' '10 2' '10 7' '11 4' '11 5' '11 8'
lines small/step-3.edges "${ring[@]/7 8/7 12}" '10 1' '10 2' '10 7' '11 4' '11 5' '11 8' '12 3' '12 8' '12 9'
run DynamicGraph small small-out --labels --track 7,8
svg small-out/steps.svg 1600
panels 2 450 small-out/steps.png@0,0,800,400 small-out/steps.png@800,0,800,400
differs 'Nodes 10, 11 and 12 are inserted by hand as published, 12 into an edge; green: neighborhoods that changed. **Agrees:**' \
  'all nodes stay in place; circles around an insertion without room shrink (step 3, orange and light blue).'

figure 6.16 'a real graph that changes'
needs graphs/power/case118.m
into outages/step-0.edges awk "$(branches '$1, $2')" case118.m
into outages/step-1.edges awk "$(branches '$1, $2' '60')" case118.m
into outages/step-2.edges awk "$(branches '$1, $2' '60 104')" case118.m
run DynamicGraph outages outages-out --track 49,80,100
svg outages-out/steps.svg 1500
panels 1 800 outages-out/steps.png
differs 'Published: an unnamed real graph. Ours: a real grid, two made-up outages. Green: changes; orange, light blue, pink:' \
  'tracked buses; below: the blue boxes. **Agrees:** all other nodes stay in place (mean displacement 0.0001 and 0.0008' \
  'rad), since small hidden circles fill the gap of a deleted edge.'

figure 6.17 'a sensor network'
run SensorNetworkSimulator hours --nodes 150 --steps 5 --range 200 --speed 10
run DynamicGraph hours hours-out
run DynamicGraph hours hours-tracked --track d00010,d00050,d00090
for picture in hours-out/steps hours-out/correspondence hours-tracked/steps; do
  svg $picture.svg 1500
done
panels 1 800 "hours-out/steps.png=(1) changes" "hours-out/correspondence.png=(2) correspondence" "hours-tracked/steps.png@0,0,1500,300=(3) tracked"
differs '150 simulated devices that move, five hours. **Agrees:** (1) changes green, (2) one color per node, (3) tracked devices. **Differs:**' \
  'with a tenth of the edges changing, nodes move by 0.08 rad on average.'
