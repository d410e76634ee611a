# The figures, in the order of the page; read by make-figures.
# shellcheck shell=bash

# rendering PICTURE: only the 3D view of a picture of HeatTransferFunction.
rendering() { printf '%s@16,64,860,620' "$1"; }
# slices PICTURE: its three slices.
slices() { printf '%s@0,700,1200,454' "$1"; }
# visits PICTURE: a preview of ShapetonDiffusion without its header, whose rate differs between runs.
visits() { printf '%s@0,70,1200,432' "$1"; }
# histogram PICTURE: without the title.
histogram() { printf '%s@0,40,1200,860' "$1"; }

write '# Figures of the dissertation, made by our tools' '' \
  'Figures of chapters 2, 3, 6 and 7.2, made by `Utilities/run-validation figures` with the commands below, from the original data' \
  'or a substitute, with the differences from the publication. `head.nii.gz` is the MR head `ch2` of Debian'"'"'s mricron-data.' \
  '`engine.nii.gz` and `bonsai.nii.gz` are the classic CT volumes of the Open SciVis collection, read from' \
  '`SHAPETON_TEST_DATA_DIR`. The commands generate all other data. Parameters are those of the dissertation where it states them.' '' \
  '| figure | shows | here |' '|---|---|---|' \
  '| 2.1, 2.9 | MR head, abdominal stent, foot | [head](#figure-29-an-mr-head); stent not available; bones of [two other feet](heat-diffusion.md#few-steps-local-shape) |' \
  '| 2.2, 3.1, 3.2, 3.3 | drawings of the method | not results |' \
  '| 2.3 | equalized and normalized histogram | [below](#figure-23-equalized-and-normalized-histogram) |' \
  '| 2.4 | a cube in time | [below](#figure-24-a-cube-in-time) |' \
  '| 2.5 | conventional and cumulative diffusion | no tool implements conventional diffusion: [table](validation/heat-figures.md) |' \
  '| 2.6 | lines of bones, one at a time | [phantom](#figure-26-one-line-at-a-time) |' \
  '| 2.7 | scale and orientation | [below](#figure-27-scale-and-orientation) |' \
  '| 2.8 | p on the engine | [below](#figure-28-p) |' \
  '| 2.10 | aneurysm | [phantom](#figure-210-vessels) |' \
  '| 2.11, 3.12 | hand of the Visible Female | not available; her [feet](heat-diffusion.md#few-steps-local-shape) |' \
  '| Table 2.1, Table 3.2 | times | [benchmarks](benchmarks.md) |' \
  '| 3.4, 3.5 | classes of shapetons | [below](#figure-34-four-shapes-by-shapetons) |' \
  '| 3.6, Table 3.1 | number of shapetons | [below](#figure-36-number-of-shapetons), [table](validation/shapeton-comparison.md) |' \
  '| 3.7 | distance | [phantom](#figure-37-distance) |' \
  '| 3.8 | p with shapetons | [below](#figure-38-p-with-shapetons) |' \
  '| 3.9 | CT chest | not available |' \
  '| 3.10 | a polyp | not made, see [PolypCandidates](../Modules/Colon/PolypCandidates/README.md) |' \
  '| 3.11 | hydrogen, hand, abdomen, head, feet | [hydrogen and head](#figure-311-hydrogen-and-head); abdomen and feet on [another page](shapetons.md) |' \
  '| 6.1, 6.5 to 6.8 | the three stages | [6.6](#figure-66-a-planar-graph), [6.8](#figure-68-genus-one); 6.7 is a drawing |' \
  '| 6.2 | graphs on surfaces | [below](#figure-62-graphs-on-surfaces) |' \
  '| 6.3 | K5, two rotation systems | [below](#figure-63-k5) |' \
  '| 6.4, 6.11, 6.12, Tables 6.1 to 6.5 | genus two and three | [below](#figure-611-genus-two-and-three) |' \
  '| 6.9, 6.10 | large graphs of genus zero and one | [below](#figure-69-large-graphs) |' \
  '| 6.13, 6.14 | isomorphic graphs | [below](#figure-613-isomorphic-graphs) |' \
  '| 6.15, 6.16 | a graph that changes | [in the guide](graph-embedding.md) |' \
  '| 6.17 | sensor network | [below](#figure-617-a-sensor-network) |' \
  '| 7.2 | bonsai | [below](#figure-72-the-bonsai-opened-up) |'

write '' '## Chapter 2: cumulative heat diffusion' ''

figure 2.3 'equalized and normalized histogram' head.nii.gz
run CumulativeHeatDiffusion head.nii.gz head.nrrd --p 20 --timeSteps 4000 --snapshotSpacing logarithmic \
  --histogram equalized.png
run CumulativeHeatDiffusion head.nii.gz head.nrrd --p 20 --timeSteps 4000 --snapshotSpacing logarithmic \
  --histogram normalized.png --histogramScale normalized
panels 2 430 "$(histogram equalized.png)=(a) equalized" "$(histogram normalized.png)=(b) normalized"
differs 'The dissertation does not name the data set; this is the MR head. As printed, equalization assigns space by the number of voxels;' \
  'without it, the lines of cool parts are crowded at the left.'

figure 2.4 'a cube in time' phantom
run ShapePhantom cube.nrrd --shape figure2.4
run CumulativeHeatDiffusion cube.nrrd cube-heat.nrrd --timeSteps 4000 --snapshotSteps 20,100,750,900,1000,1100 \
  --snapshotFolder cube-steps --histogram cube-histogram.png
cube=()
for step in 20 100 750 900 1000 1100; do
  run HeatTransferFunction cube.nrrd cube-steps "cube-$step.vp" --timeStep $step --lines 0.026-0.036:orange:0.4,0.036-1:red:0.9 \
    --picture "cube-$step.png"
  cube+=("$(rendering "cube-$step.png")=t = $step")
done
panels 3 280 "${cube[@]}" "$(histogram cube-histogram.png)=4000 steps"
differs 'Orange: within 15 % of the final heat; red: hotter. As printed, faces reach the final heat first, then edges, then corners, and one' \
  'line remains. The line has two columns, because 1/32 is the border of two bins. The steps at which a feature is captured depend on' \
  'the size of the cube and the thresholds, which are not printed: [values](validation/heat-figures.md).'

figure 2.6 'one line at a time' phantom
run ShapePhantom four.nrrd --shape figure2.7b --size 96,96,96
run CumulativeHeatDiffusion four.nrrd four-heat.nrrd --timeSteps 40000 --histogram four-histogram.png
bones=()
for line in 0.0415-0.0445:tomato:1 0.0465-0.0495:yellow:1 0.063-0.068:lime:1 0.07-0.076:skyblue:1; do
  run HeatTransferFunction four.nrrd four-heat.nrrd four.vp --lines $line --picture "four-${line%%:*}.png"
  bones+=("$(rendering "four-${line%%:*}.png")=${line%%:*}")
done
panels 2 330 "${bones[@]}"
differs 'A phantom replaces the foot, which is not available: four objects, each rendered from its own line. Lines separate objects by' \
  'their ratio of surface to volume; they do not identify objects.'

figure 2.7 'scale and orientation' phantom
run ShapePhantom a.nrrd --shape figure2.7a --size 96,96,96
run CumulativeHeatDiffusion a.nrrd a-heat.nrrd --timeSteps 40000 --histogram a-histogram.png
run HeatTransferFunction a.nrrd a-heat.nrrd a.vp --picture a.png
run ShapePhantom four.nrrd --shape figure2.7b --size 96,96,96
run CumulativeHeatDiffusion four.nrrd four-heat.nrrd --timeSteps 40000 --histogram four-histogram.png
run HeatTransferFunction four.nrrd four-heat.nrrd four.vp --picture four.png
panels 2 400 "$(rendering a.png)=(a) two spheres, a cube" "$(histogram a-histogram.png)" \
  "$(rendering four.png)=(b) two cubes, two cuboids" "$(histogram four-histogram.png)"
differs 'Three and four lines, as printed. **Not as claimed:** the lines of one shape in two sizes are not close to each other. Heat decreases' \
  'with size: the spheres differ by a factor of 2, the ratio of their radii. The scale-normalized `normalizedHeat` of the class table' \
  'differs by 0.1 % between the spheres ([values](validation/heat-figures.md)).'

figure 2.8 'p' engine.nii.gz
engine=()
for p in 2 5 10 15; do
  run CumulativeHeatDiffusion engine.nii.gz engine-$p.nrrd --p $p --timeSteps 100
  run HeatTransferFunction engine.nii.gz engine-$p.nrrd engine.vp --lines '0.08-0.2:#3c6bdf:0.15,0.2-1:#dd3d2c:1' \
    --picture engine-$p.png
  engine+=("$(rendering engine-$p.png)=p = $p")
done
panels 2 400 "${engine[@]}"
differs 'As printed, p = 2 and 5 differ much, 10 and 15 little. The choice of rendered heats is ours.'

figure 2.9 'an MR head' head.nii.gz
run CumulativeHeatDiffusion head.nii.gz head-late.nrrd --p 20 --timeSteps 400000
run HeatTransferFunction head.nii.gz head-late.nrrd head.vp --picture head-late.png
run CumulativeHeatDiffusion head.nii.gz head-early.nrrd --p 20 --timeSteps 2000
run HeatTransferFunction head.nii.gz head-early.nrrd head.vp --lines 0.39-0.5:lime:0.9,0.58-0.8:red:0.15 --picture head-early.png
panels 2 420 "$(rendering head-late.png)=400,000 steps" "$(rendering head-early.png)=2,000 steps, two lines" \
  "$(slices head-late.png)" "$(slices head-early.png)"
differs 'A different head, which needs p = 20 ([what p does](heat-diffusion.md#what-p-does)) instead of 6. **Not as printed:** after 400,000' \
  'steps, brain, skull and neck are one class; the scalp at the vertex and an eye keep their heat. At 2,000 steps, one line (green)' \
  'contains eyes, muscles and the front of the brain, another (red) the scalp. Neither shows the brain alone.'

figure 2.10 'vessels' phantom
run ShapePhantom vessels.nrrd --shape vessels --size 128,128,128
run CumulativeHeatDiffusion vessels.nrrd vessels-heat.nrrd --p 7.5 --timeSteps 2000 --histogram vessels-histogram.png \
  --histogramRange 0.045,0.3
run HeatTransferFunction vessels.nrrd vessels-heat.nrrd vessels.vp --lines 0.05-0.0569:yellow:1,0.0569-0.0854:red:1,0.0854-1:lime:1 \
  --picture vessels.png
panels 2 400 "$(rendering vessels.png)" "$(histogram vessels-histogram.png)=heats from 0.045 to 0.3"
differs 'A phantom replaces the aneurysm. As printed, heat distinguishes blob, large vessel and thin vessels after 2,000 steps. After the' \
  '100,000 steps of Table 2.1 it does not, because connected vessels reach the same heat.'

write '## Chapter 3: shapetons' '' \
  'The published walk is `--directionSampling sectorArea` with the default `--pathRule endpoint --placement uniform`. Colors are' \
  'density classes; [CHD or shapetons?](shapetons.md) explains them.' ''

figure 3.4 'four shapes by shapetons' phantom
shapes=()
for shape in figure3.4 figure3.5; do
  run ShapePhantom $shape.nrrd --shape $shape --size 96,96,96
  run ShapetonDiffusion $shape.nrrd $shape-published.nrrd --directionSampling sectorArea --report $shape-published
  run ShapetonDiffusion $shape.nrrd $shape-controlled.nrrd --shapetons 50000 --timeSteps 1000 --distance 0.01 \
    --pathRule traversal --directionSampling uniform --placement initialHeat --report $shape-controlled
  shapes+=("$(rendering $shape-published/rendering.png)=$shape published" "$(rendering $shape-controlled/rendering.png)=$shape controlled")
done
panels 2 400 "${shapes[@]}"
differs '3.4 above, 3.5 below; colors are density classes. **Not as claimed:** the published walk finds one class, the whole volume. The' \
  'controlled walk, with fewer shapetons than on [its page](shapetons.md), distinguishes objects by surface over volume: the cube from' \
  'the sphere, but not from the large cuboid. Both spheres of 3.5 have the same class; the deformed cuboid differs from the cuboid.'

figure 3.6 'number of shapetons' phantom
run ShapePhantom cube128.nrrd --shape figure2.4 --size 128,128,128
many=()
for shapetons in 4000 8000 15000 30000; do
  run ShapetonDiffusion cube128.nrrd many-$shapetons.nrrd --shapetons $shapetons --timeSteps 1600 --directionSampling sectorArea \
    --preview many-$shapetons.png --previewEvery 1000
  many+=("$(visits "many-$shapetons.png")=$shapetons")
done
panels 2 400 "${many[@]}"
differs 'Slices of the visits of a cube in 128^3. As printed, more shapetons cover more of it: 92 %, 99 %, 100 % and 100 % of its voxels.' \
  'Only coverage is visible: the walk does not show any shape inside the cube.'

figure 3.7 'distance' phantom
run ShapePhantom vessels.nrrd --shape vessels --size 128,128,128
run ShapePhantom vessels.nrrd --shape vessels --size 128,128,128 --labels vessels-labels.nrrd
steps=()
for distance in 0.001 0.005 0.01 0.05; do
  run ShapetonDiffusion vessels.nrrd vessels-$distance.nrrd --timeSteps 400 --distance $distance --p 7.5 \
    --directionSampling sectorArea --mask vessels-labels.nrrd --preview vessels-$distance.png --previewEvery 1000
  steps+=("$(visits "vessels-$distance.png")=distance $distance")
done
panels 2 400 "${steps[@]}"
differs 'A phantom; shapetons start in its vessels. As printed, thin vessels are visible at small distances and lost at large ones, because' \
  'steps jump over walls: at 0.05, most visits are outside of all vessels.'

figure 3.8 'p with shapetons' engine.nii.gz
pipes=()
for p in 4 9 15 20; do
  run ShapetonDiffusion engine.nii.gz engine-shapetons-$p.nrrd --p $p --timeSteps 1300 --distance 0.05 \
    --directionSampling sectorArea --preview engine-shapetons-$p.png --previewEvery 1000
  pipes+=("$(visits "engine-shapetons-$p.png")=p = $p")
done
panels 2 400 "${pipes[@]}"
differs 'Slices instead of a rendering. From p = 15 on, visits accumulate where noise isolates voxels, and less of the engine is reached' \
  '(100 %, 100 %, 97 %, 81 %). **Not as printed:** pipe, rim and beam do not appear one after the other.'

figure 3.11 'hydrogen and head' head.nii.gz
run ShapePhantom hydrogen.nrrd --shape hydrogen --size 96,96,96
run ShapetonDiffusion hydrogen.nrrd hydrogen-visits.nrrd --shapetons 50000 --timeSteps 1000 --distance 0.01 \
  --pathRule traversal --directionSampling uniform --placement initialHeat --report hydrogen
run ShapetonDiffusion head.nii.gz head-visits.nrrd --p 6 --timeSteps 4160 --directionSampling sectorArea --report head-shapetons
panels 2 400 "$(rendering hydrogen/rendering.png)=(a) hydrogen, controlled walk" "$(rendering head-shapetons/rendering.png)=(d) head, as published"
differs '(a) Controlled walk: as printed, the lobes have the same class, different from nucleus and orbit. (d) **Not as printed:** in the' \
  'published walk, the head and the surrounding air are one class; heat shows more (2.9).'

write '## Chapter 6: graphs on surfaces' '' \
  'Nodes are red, the dual graph is green. `GraphEmbeddingVerifier` verifies each certificate.' ''

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

figure 6.2 'graphs on surfaces' phantom
lines cube.edges '1 2' '2 3' '3 4' '4 1' '5 6' '6 7' '7 8' '8 5' '1 5' '2 6' '3 7' '4 8'
complete k7.edges 7
complete k8.edges 8
embed cube cube.edges
embed k7 k7.edges
embed k8 k8.edges
panels 1 520 cube.png k7.png k8.png
differs 'Cube on the sphere (genus 0), K7 on the torus (1), K8 on the Poincare disk (2). For tori in 3D, see 6.8. The printed graphs are not' \
  'given, so these are different ones.'

figure 6.3 'K5' phantom
complete k5.edges 5
embed k5-three k5.edges --genus 2
embed k5 k5.edges
panels 1 700 k5-three.png=genus\ 2 k5.png=genus\ 1
differs 'K5 on a surface of genus 2, and on one of minimum genus 1, as printed.'

figure 6.6 'a planar graph' phantom
lines planar.edges '1 2' '2 3' '3 4' '4 1' '1 5' '2 5' '3 5' '4 5' '2 6' '3 6' '5 6'
embed planar planar.edges
panels 1 700 planar.png
differs 'Overlap graph, circles and sphere are the stages (a), (c) and (d), for a different graph.'

figure 6.8 'genus one' phantom
lines k33.edges 'a x' 'a y' 'a z' 'b x' 'b y' 'b z' 'c x' 'c y' 'c z'
embed k33 k33.edges
panels 1 700 k33.png
differs 'K3,3 instead of the printed graph, which is not given: its flat torus as a tiling of the plane (a). `--surface F.vtp` writes the' \
  'torus in 3D (b) to a file.'

figure 6.9 'large graphs' phantom
run SensorNetworkSimulator network --nodes 3000 --steps 1 --range 40
embed network network/step-0000.graphml
panels 1 560 network.png
differs 'A planar network of 3,000 devices, with the largest components side by side, instead of a graph of 3,000 nodes and 6,000 edges that' \
  'is not given. 6.10, genus 1 with 10,000 nodes, is not drawn, because its circles would be too small.'

figure 6.11 'genus two and three' phantom
complete k8.edges 8
complete k9.edges 9
embed k8 k8.edges
embed k9 k9.edges
panels 1 600 k8.png k9.png
differs 'K8 (genus 2) and K9 (genus 3) in the Poincare disk. The generators of Tables 6.1 to 6.5 are for other graphs; the certificate' \
  'contains ours, with the residual of their relation.'

figure 6.13 'isomorphic graphs' phantom
lines one.edges '1 2' '2 3' '3 4' '4 1' '1 5' '2 5' '3 5' '4 5' '2 6' '3 6' '5 6'
lines other.edges 'c f' 'f a' 'a e' 'e c' 'c b' 'f b' 'a b' 'e b' 'f d' 'a d' 'b d'
run GraphCompare one.edges other.edges same --labels
svg same/comparison.svg 900
panels 1 700 same/comparison.png
differs 'Two numberings of a graph have the same circles in the same colors, as printed, for a different graph. `comparison.json` states' \
  '`isomorphic`.'

figure 6.17 'a sensor network' phantom
run SensorNetworkSimulator hours --nodes 150 --steps 5 --range 200 --speed 10
run DynamicGraph hours hours-out --compare 0,4
svg hours-out/steps.svg 1000
svg hours-out/correspondence.svg 1000
panels 1 700 hours-out/steps.png hours-out/correspondence.png
differs 'Five steps of a simulated network instead of the measured one. Above: changes since the previous step in green; below: one color per' \
  'node through all steps, as printed.'

write '## Chapter 7: histograms that open up' ''

figure 7.2 'the bonsai, opened up' bonsai.nii.gz
run CumulativeHeatDiffusion bonsai.nii.gz bonsai-heat.nrrd --intensityWindow 0,80 --p 8.5 --timeSteps 20000 \
  --snapshots 200 --snapshotSpacing logarithmic --histogramRange 0.15,0.75 --report bonsai
panels 2 480 "$(histogram bonsai/histogram.png)=all heats" "$(histogram bonsai/histogram-range.png)=0.15 to 0.75" \
  "$(rendering bonsai/rendering-range.png)=the lines inside"
differs 'p and the number of steps of this figure are not printed; with p = 8.5 of the whole window (Table 2.1), all heat leaks within' \
  '300,000 steps. [Histograms that open up](heat-diffusion.md#histograms-that-open-up) discusses the opened range.'

figure 7.2-head 'ventricles of an MR head, opened up' head.nii.gz
run CumulativeHeatDiffusion head.nii.gz head-heat.nrrd --p 20 --timeSteps 32000 --snapshots 200 \
  --snapshotSpacing logarithmic --histogramRange 0.25,0.45,0.335,0.35 --report head
panels 2 480 "$(histogram head/histogram-range.png)=0.335 to 0.35" "head/rendering-range.png@16,700,1184,440=its voxels"
differs 'Not a figure of the dissertation, but a second example of' \
  '[histograms that open up](heat-diffusion.md#histograms-that-open-up). On the right: the ventricles, and the part of the brain with' \
  'the same heat.'
