# The figures, in the order of the page; read by make-figures.
# shellcheck shell=bash

# rendering PICTURE: crops the 3D view of a picture of HeatTransferFunction.
rendering() { printf '%s@16,64,860,620' "$1"; }
# slices PICTURE: crops its three slices.
slices() { printf '%s@0,700,1200,454' "$1"; }
# visits PICTURE: crops a preview of ShapetonDiffusion without its header, which shows a rate that differs between runs.
visits() { printf '%s@0,70,1200,432' "$1"; }
# histogram PICTURE: crops a histogram without its title.
histogram() { printf '%s@0,40,1200,860' "$1"; }

write '# Figures of the dissertation, made by our tools' '' \
  'For readers of the dissertation: which figures our tools reproduce, with which parameters, and what differs.' \
  '`Utilities/run-validation figures` makes them with the commands in [figures.sh](../Testing/Figures/figures.sh). Parameters are' \
  'those of the dissertation where it states them. The head is `ch2` of Debian'"'"'s mricron-data; engine and bonsai are CT volumes' \
  'of the Open SciVis collection (`SHAPETON_TEST_DATA_DIR`); the commands generate all other data.' '' \
  'Figures not shown below:' '' \
  '| figure | shows | here |' '|---|---|---|' \
  '| 2.1 | MR head, abdominal stent, foot | head: 2.9; stent not available; [two other feet](heat-diffusion.md#few-steps-local-shape) |' \
  '| 2.2, 3.1 to 3.3, 6.7 | drawings of the method | not results |' \
  '| 2.5 | conventional and cumulative diffusion | [table](validation/heat.md#figures-24-25-and-27-of-the-dissertation); no tool implements conventional diffusion |' \
  '| 2.11, 3.12 | hand of the Visible Female | not available; her [feet](heat-diffusion.md#few-steps-local-shape) |' \
  '| Tables 2.1, 3.2 | times | [benchmarks](benchmarks.md), [shapetons](shapetons.md) |' \
  '| Table 3.1 | number of shapetons | [table](validation/shapetons.md#chd-or-shapetons) |' \
  '| 3.9 | CT chest | not available |' \
  '| 3.10 | a polyp | not made, see [PolypCandidates](../Modules/Colon/PolypCandidates/README.md) |' \
  '| 6.1, 6.5; 6.4, 6.12; 6.10; 6.14 | graphs | see 6.6; 6.11; 6.9; 6.13 |' \
  '| 6.15, 6.16 | a graph that changes | [guide](graph-embedding.md) |'

write '' '## Chapter 2: cumulative heat diffusion' ''

figure 2.3 'equalized and normalized histogram' head.nii.gz
run CumulativeHeatDiffusion head.nii.gz head.nrrd --p 20 --timeSteps 4000 --snapshotSpacing logarithmic \
  --histogram equalized.png
run CumulativeHeatDiffusion head.nii.gz head.nrrd --p 20 --timeSteps 4000 --snapshotSpacing logarithmic \
  --histogram normalized.png --histogramScale normalized
panels 2 430 "$(histogram equalized.png)=(a) equalized" "$(histogram normalized.png)=(b) normalized"
differs 'Ours: MR head, p = 20, 4,000 steps; the dissertation does not name its data set. **Agrees:** equalization assigns space by' \
  'the number of voxels; without it, the lines of cool parts are crowded at the left.'

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
differs 'Ours: 4,000 steps. Orange: within 15 % of the final heat; red: hotter. **Agrees:** faces reach the final heat' \
  'first, then edges, then corners; one line remains. **Not comparable:** the steps depend on the size of the cube' \
  'and the thresholds, which are not printed ([values](validation/heat.md#figures-24-25-and-27-of-the-dissertation)).'

figure 2.6 'one line at a time' phantom
run ShapePhantom four.nrrd --shape figure2.7b --size 96,96,96
run CumulativeHeatDiffusion four.nrrd four-heat.nrrd --timeSteps 40000 --histogram four-histogram.png
bones=()
for line in 0.0415-0.0445:tomato:1 0.0465-0.0495:yellow:1 0.063-0.068:lime:1 0.07-0.076:skyblue:1; do
  run HeatTransferFunction four.nrrd four-heat.nrrd four.vp --lines $line --picture "four-${line%%:*}.png"
  bones+=("$(rendering "four-${line%%:*}.png")=${line%%:*}")
done
panels 2 330 "${bones[@]}"
differs 'Ours: a phantom of four objects instead of the foot; 40,000 steps. **Agrees:** each line shows its object. Lines' \
  'separate objects by surface over volume; they do not identify them.'

figure 2.7 'scale and orientation' phantom
run ShapePhantom a.nrrd --shape figure2.7a --size 96,96,96
run CumulativeHeatDiffusion a.nrrd a-heat.nrrd --timeSteps 40000 --histogram a-histogram.png
run HeatTransferFunction a.nrrd a-heat.nrrd a.vp --picture a.png
run ShapePhantom four.nrrd --shape figure2.7b --size 96,96,96
run CumulativeHeatDiffusion four.nrrd four-heat.nrrd --timeSteps 40000 --histogram four-histogram.png
run HeatTransferFunction four.nrrd four-heat.nrrd four.vp --picture four.png
panels 2 400 "$(rendering a.png)=(a) two spheres, a cube" "$(histogram a-histogram.png)" \
  "$(rendering four.png)=(b) two cubes, two cuboids" "$(histogram four-histogram.png)"
differs 'Ours: 40,000 steps. **Agrees:** three and four lines. **Differs:** the lines of one shape in two sizes are not' \
  'close to each other. The heat values of the spheres differ by a factor of 2, the ratio of their radii; their' \
  '`normalizedHeat` differs by 0.1 % ([values](validation/heat.md#figures-24-25-and-27-of-the-dissertation)).'

figure 2.8 'p' engine.nii.gz
engine=()
for p in 2 5 10 15; do
  run CumulativeHeatDiffusion engine.nii.gz engine-$p.nrrd --p $p --timeSteps 100
  run HeatTransferFunction engine.nii.gz engine-$p.nrrd engine.vp --lines '0.08-0.2:#3c6bdf:0.15,0.2-1:#dd3d2c:1' \
    --picture engine-$p.png
  engine+=("$(rendering engine-$p.png)=p = $p")
done
panels 2 400 "${engine[@]}"
differs 'Ours: 100 steps; the rendered heat ranges are our choice. **Agrees:** p = 2 and 5 differ much, 10 and 15 little.'

figure 2.9 'an MR head' head.nii.gz
run CumulativeHeatDiffusion head.nii.gz head-late.nrrd --p 20 --timeSteps 400000
run HeatTransferFunction head.nii.gz head-late.nrrd head.vp --picture head-late.png
run CumulativeHeatDiffusion head.nii.gz head-early.nrrd --p 20 --timeSteps 2000
run HeatTransferFunction head.nii.gz head-early.nrrd head.vp --lines 0.39-0.5:lime:0.9,0.58-0.8:red:0.15 --picture head-early.png
panels 2 420 "$(rendering head-late.png)=400,000 steps" "$(rendering head-early.png)=2,000 steps, two lines" \
  "$(slices head-late.png)" "$(slices head-early.png)"
differs 'Published: p = 6, 400,000 steps. Ours: another head, p = 20 ([what p does](heat-diffusion.md#what-p-does)),' \
  '400,000 and 2,000 steps. **Differs:** after 400,000 steps, brain, skull and neck are one class. At 2,000 steps,' \
  'one line (green) contains eyes, muscles and the front of the brain, another (red) the scalp.'

figure 2.10 'vessels' phantom
run ShapePhantom vessels.nrrd --shape vessels --size 128,128,128
run CumulativeHeatDiffusion vessels.nrrd vessels-heat.nrrd --p 7.5 --timeSteps 2000 --histogram vessels-histogram.png \
  --histogramRange 0.045,0.3
run HeatTransferFunction vessels.nrrd vessels-heat.nrrd vessels.vp --lines 0.05-0.0569:yellow:1,0.0569-0.0854:red:1,0.0854-1:lime:1 \
  --picture vessels.png
panels 2 400 "$(rendering vessels.png)" "$(histogram vessels-histogram.png)=heats from 0.045 to 0.3"
differs 'Published: aneurysm, p = 7.5, 100,000 steps. Ours: a phantom, p = 7.5, 2,000 steps. **Agrees:** heat' \
  'distinguishes blob, large vessel and thin vessels. **Differs:** after 100,000 steps, connected vessels have the' \
  'same heat.'

write '## Chapter 3: shapetons' '' \
  'Colors are density classes. [CHD or shapetons?](shapetons.md) defines the *published* and the *controlled* walk. Figures 3.6 to' \
  '3.8 and 3.11 (d) show the published walk with 65,000 shapetons unless stated, 3.11 (a) the controlled walk.' ''

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
differs '3.4 above, 3.5 below. Ours: published walk with 65,000 shapetons and 2,500 steps; controlled walk with 50,000' \
  'and 1,000. **Differs:** the published walk finds one class. The controlled walk distinguishes objects by surface' \
  'over volume: the cube from the sphere, but not from the large cuboid. Both spheres of 3.5 have the same class;' \
  'the deformed cuboid differs from the cuboid.'

figure 3.6 'number of shapetons' phantom
run ShapePhantom cube128.nrrd --shape figure2.4 --size 128,128,128
many=()
for shapetons in 4000 8000 15000 30000; do
  run ShapetonDiffusion cube128.nrrd many-$shapetons.nrrd --shapetons $shapetons --timeSteps 1600 --directionSampling sectorArea \
    --preview many-$shapetons.png --previewEvery 1000
  many+=("$(visits "many-$shapetons.png")=$shapetons")
done
panels 2 400 "${many[@]}"
differs 'Visits of a cube in 128^3, 1,600 steps. **Agrees:** more shapetons cover more voxels of the cube (92 %, 99 %,' \
  '100 %, 100 %). The walk shows no shape inside the cube.'

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
differs 'Ours: a phantom, p = 7.5, 400 steps, shapetons start in the vessels. **Agrees:** thin vessels are visible at' \
  'small distances and lost at large ones, because steps jump over walls.'

figure 3.8 'p with shapetons' engine.nii.gz
pipes=()
for p in 4 9 15 20; do
  run ShapetonDiffusion engine.nii.gz engine-shapetons-$p.nrrd --p $p --timeSteps 1300 --distance 0.05 \
    --directionSampling sectorArea --preview engine-shapetons-$p.png --previewEvery 1000
  pipes+=("$(visits "engine-shapetons-$p.png")=p = $p")
done
panels 2 400 "${pipes[@]}"
differs 'Ours: 1,300 steps, distance 0.05. **Differs:** pipe, rim and beam do not appear one after the other. From p = 15' \
  'on, visits accumulate where noise isolates voxels, and less of the engine is reached (100 %, 100 %, 97 %, 81 %).'

figure 3.11 'hydrogen and head' head.nii.gz
run ShapePhantom hydrogen.nrrd --shape hydrogen --size 96,96,96
run ShapetonDiffusion hydrogen.nrrd hydrogen-visits.nrrd --shapetons 50000 --timeSteps 1000 --distance 0.01 \
  --pathRule traversal --directionSampling uniform --placement initialHeat --report hydrogen
run ShapetonDiffusion head.nii.gz head-visits.nrrd --p 6 --timeSteps 4160 --directionSampling sectorArea --report head-shapetons
panels 2 400 "$(rendering hydrogen/rendering.png)=(a) hydrogen, controlled walk" "$(rendering head-shapetons/rendering.png)=(d) head, as published"
differs '(a) 50,000 shapetons, 1,000 steps. **Agrees:** the lobes have one class, different from nucleus and orbit. (d) p' \
  '= 6, 4,160 steps. **Differs:** the head and the surrounding air are one class.'

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
differs 'Cube on the sphere (genus 0), K7 on the torus (1), K8 on the Poincare disk (2). The printed graphs are not' \
  'given.'

figure 6.3 'K5' phantom
complete k5.edges 5
embed k5-three k5.edges --genus 2
embed k5 k5.edges
panels 1 700 k5-three.png=genus\ 2 k5.png=genus\ 1
differs '**Agrees:** K5 on a surface of genus 2, and of the minimum genus 1.'

figure 6.6 'a planar graph' phantom
lines planar.edges '1 2' '2 3' '3 4' '4 1' '1 5' '2 5' '3 5' '4 5' '2 6' '3 6' '5 6'
embed planar planar.edges
panels 1 700 planar.png
differs 'Stages (a), (c) and (d) for another graph: overlap graph, circles, sphere.'

figure 6.8 'genus one' phantom
lines k33.edges 'a x' 'a y' 'a z' 'b x' 'b y' 'b z' 'c x' 'c y' 'c z'
embed k33 k33.edges
panels 1 700 k33.png
differs 'Ours: K3,3; the printed graph is not given. The flat torus tiles the plane (a); `--surface F.vtp` writes the' \
  'torus in 3D (b).'

figure 6.9 'large graphs' phantom
run SensorNetworkSimulator network --nodes 3000 --steps 1 --range 40
embed network network/step-0000.graphml
panels 1 560 network.png
differs 'Published: 3,000 nodes and 6,000 edges. Ours: a planar network of 3,000 devices. 6.10, genus 1 with 10,000' \
  'nodes, is not drawn: its circles would be too small.'

figure 6.11 'genus two and three' phantom
complete k8.edges 8
complete k9.edges 9
embed k8 k8.edges
embed k9 k9.edges
panels 1 600 k8.png k9.png
differs 'Ours: K8 (genus 2) and K9 (genus 3) in the Poincare disk. The generators of Tables 6.1 to 6.5 are for other' \
  'graphs; the certificate contains ours.'

figure 6.13 'isomorphic graphs' phantom
lines one.edges '1 2' '2 3' '3 4' '4 1' '1 5' '2 5' '3 5' '4 5' '2 6' '3 6' '5 6'
lines other.edges 'c f' 'f a' 'a e' 'e c' 'c b' 'f b' 'a b' 'e b' 'f d' 'a d' 'b d'
run GraphCompare one.edges other.edges same --labels
svg same/comparison.svg 900
panels 1 700 same/comparison.png
differs '**Agrees:** two numberings of a graph, not the printed one, have the same circles in the same colors.'

figure 6.17 'a sensor network' phantom
run SensorNetworkSimulator hours --nodes 150 --steps 5 --range 200 --speed 10
run DynamicGraph hours hours-out --compare 0,4
svg hours-out/steps.svg 1000
svg hours-out/correspondence.svg 1000
panels 1 700 hours-out/steps.png hours-out/correspondence.png
differs 'Ours: five steps of a simulated network. Above: changes since the previous step in green. **Agrees** (below):' \
  'one color per node through all steps.'

write '## Chapter 7: histograms that open up' ''

figure 7.2 'the bonsai, opened up' bonsai.nii.gz
run CumulativeHeatDiffusion bonsai.nii.gz bonsai-heat.nrrd --intensityWindow 0,80 --p 8.5 --timeSteps 20000 \
  --snapshots 200 --snapshotSpacing logarithmic --histogramRange 0.15,0.75 --report bonsai
panels 2 480 "$(histogram bonsai/histogram.png)=all heats" "$(histogram bonsai/histogram-range.png)=0.15 to 0.75" \
  "$(rendering bonsai/rendering-range.png)=the lines inside"
differs 'Published: p and steps not printed. Ours: window 0 to 80, p = 8.5 (Table 2.1), 20,000 steps. With this p for the' \
  'whole window, all heat leaks within 300,000 steps. See [histograms that open' \
  'up](heat-diffusion.md#histograms-that-open-up).'

figure 7.2-head 'ventricles of an MR head, opened up' head.nii.gz
run CumulativeHeatDiffusion head.nii.gz head-heat.nrrd --p 20 --timeSteps 32000 --snapshots 200 \
  --snapshotSpacing logarithmic --histogramRange 0.25,0.45,0.335,0.35 --report head
panels 2 480 "$(histogram head/histogram-range.png)=0.335 to 0.35" "head/rendering-range.png@16,700,1184,440=its voxels"
differs 'A second example, not in the dissertation: p = 20, 32,000 steps. On the right: the ventricles, and the part of' \
  'the brain with the same heat.'
