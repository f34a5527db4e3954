/* jacobi/period_table.h - the quarter period K from a table of polynomials

   To reduce a large argument, the quarter period K is needed with more digits than a vm_real has. The
   arithmetic-geometric mean gives these digits (jacobi/agm.h), but this method is slow, since it takes one square root
   after another. Here K comes from one of 25 polynomials in k' = sqrt(1 - m), for k' from 0.171875 to 1.5. Each octave
   of k', an interval from 2^n to 2^(n+1), is divided into eight pieces of equal length. Each piece has its own
   polynomial c_0 + c_1 t + c_2 t^2 + ..., where t is k' minus the middle of the piece. The table takes 3.8 kB (float
   1 kB).

       vmi_period K = vmi_period_by_table(VM_C(0.5), 0, VM_SQRT(VM_C(0.5))); // K(0.5) = K.head + K.middle + K.low

   The table is computed by tests/gen/period_table.py. Tests: tests/test_jacobi.c, tests/scan.c. */
#ifndef VARMASS_JACOBI_PERIOD_TABLE_H
#define VARMASS_JACOBI_PERIOD_TABLE_H

#include "../base/bits.h"
#include "../base/real.h"
#include "../base/sums.h"
#include "../base/words.h"

/* VMI_IN_PERIOD_TABLE(kp) is 1 if the table gives the quarter period for k' = kp, else 0. */
#define VMI_IN_PERIOD_TABLE(kp) ((kp) >= VM_C(0.171875) && (kp) < VM_C(1.5))

/* The number of polynomials and the number of constants of each. The first five coefficients (float three) have two
   words, the others one: constants 0 and 1 are the two words of c_0, constants 2 and 3 those of c_1, and so on. */
enum { VMI_PERIOD_ROWS = 25, VMI_PERIOD_COLUMNS = VM_MANT_DIG > 24 ? 19 : 10 };

/* Returns a constant of the polynomial number `row`. */
VM_INLINE vm_real vmi_period_constant(vmi_bits row, int column)
{
#if VM_MANT_DIG > 24
    VM_TABLE vm_real table[VMI_PERIOD_ROWS][VMI_PERIOD_COLUMNS] = {
        {VM_C(3.1200943840667605), VM_C(3.2234590877852483e-10), VM_C(-5.415517104032915),
         VM_C(7.073287238700407e-12), VM_C(15.67579460144043), VM_C(2.3814758196689725e-07), VM_C(-57.8125),
         VM_C(-0.004351889902599495), VM_C(240.48583984375), VM_C(4.312139751079842e-05),
         VM_C(-1069.2008992812432), VM_C(4955.6961400199425), VM_C(-23632.804742462962),
         VM_C(115063.07701061308), VM_C(-569144.8978358798), VM_C(2850452.894803547), VM_C(-14420605.228307953),
         VM_C(73983142.13974646), VM_C(-380075184.2342842)},
        {VM_C(3.039096879772842), VM_C(-1.458724772615982e-10), VM_C(-4.964618488345877),
         VM_C(-6.175192369676107e-13), VM_C(13.281128406524658), VM_C(1.381353788217289e-07), VM_C(-45.0625),
         VM_C(-0.00017478324492667952), VM_C(172.36865234375), VM_C(-7.019827812869866e-05),
         VM_C(-704.879174359522), VM_C(3005.383099578208), VM_C(-13184.823964719959), VM_C(59056.77147964698),
         VM_C(-268742.5292560721), VM_C(1238259.1472850563), VM_C(-5763222.833350258), VM_C(27178129.55499403),
         VM_C(-128451143.02714698)},
        {VM_C(2.964604936540127), VM_C(1.9806473684746738e-10), VM_C(-4.580152494309004),
         VM_C(7.386454342880199e-13), VM_C(11.396871089935303), VM_C(-1.9109587175333132e-07), VM_C(-35.8125),
         VM_C(0.0065342859157047194), VM_C(126.7637939453125), VM_C(4.2992866992529755e-05),
         VM_C(-479.868687700217), VM_C(1894.2261774170013), VM_C(-7694.073914388595), VM_C(31909.02329123051),
         VM_C(-134445.94694798795), VM_C(573580.5560160861), VM_C(-2471841.4973641424),
         VM_C(10785726.811449626), VM_C(-47199635.01901083)},
        {VM_C(2.8956930385902524), VM_C(4.1164163562992076e-10), VM_C(-4.248424245524802),
         VM_C(4.832487385927097e-12), VM_C(9.887404918670654), VM_C(9.076335017600868e-08), VM_C(-28.921875),
         VM_C(-0.0029242539858942334), VM_C(95.3026123046875), VM_C(1.9727003929496146e-05),
         VM_C(-335.80561273979396), VM_C(1233.9778410987187), VM_C(-4666.2620355323), VM_C(18016.743212843427),
         VM_C(-70675.1519620111), VM_C(280720.2490710035), VM_C(-1126319.126381069), VM_C(4573134.735204485),
         VM_C(-18632196.255222023)},
        {VM_C(2.8316203728318214), VM_C(-8.791794729532627e-11), VM_C(-3.9592674190644175),
         VM_C(-9.551979322508738e-13), VM_C(8.659367561340332), VM_C(-2.149465674630339e-07), VM_C(-23.703125),
         VM_C(0.0001730894316877254), VM_C(73.0313720703125), VM_C(5.3992389736135624e-05),
         VM_C(-240.6668341401514), VM_C(827.2039203726936), VM_C(-2926.0370678765626), VM_C(10568.326069653982),
         VM_C(-38781.32801349843), VM_C(144098.6089929801), VM_C(-540852.9836640635), VM_C(2053386.2619395081),
         VM_C(-7826226.208588889)},
        {VM_C(2.743297071196139), VM_C(-4.324482224456551e-10), VM_C(-3.588990932039451),
         VM_C(-2.1011362891506352e-12), VM_C(7.2058265209198), VM_C(-1.183130746249538e-08), VM_C(-18.0),
         VM_C(0.007523341960603012), VM_C(50.518798828125), VM_C(2.5398078091927636e-06),
         VM_C(-151.72906408506452), VM_C(475.39277780075594), VM_C(-1533.0350234303698),
         VM_C(5048.159731634414), VM_C(-16889.44514976924), VM_C(57214.73175744805), VM_C(-195795.2365218889),
         VM_C(682723.7911603191), VM_C(-2372688.2581241406)},
        {VM_C(2.637673015706241), VM_C(4.582302920084496e-10), VM_C(-3.1858196995963226),
         VM_C(-2.5706228498877993e-12), VM_C(5.774693489074707), VM_C(1.56321033874785e-08), VM_C(-12.9140625),
         VM_C(0.0009709230250467727), VM_C(32.42059326171875), VM_C(-2.599290676722129e-06),
         VM_C(-87.07568404833184), VM_C(244.02739796700465), VM_C(-703.9766422779214), VM_C(2073.9207337842554),
         VM_C(-6207.893140363168), VM_C(18815.774182295358), VM_C(-57610.361505866495),
         VM_C(179358.90847286125), VM_C(-557696.5257574626)},
        {VM_C(2.543389955535531), VM_C(-6.998650763845314e-12), VM_C(-2.859150813128508),
         VM_C(9.20059316502088e-13), VM_C(4.730580806732178), VM_C(-1.050051139737992e-07), VM_C(-9.5859375),
         VM_C(0.0035496619016598917), VM_C(21.75604248046875), VM_C(-6.919248586850534e-07),
         VM_C(-52.83916534421908), VM_C(133.93211746283637), VM_C(-349.50633690730655), VM_C(931.4836962327715),
         VM_C(-2522.5085366296844), VM_C(6917.194648024937), VM_C(-19161.532296368427), VM_C(53891.22274350994),
         VM_C(-151604.9414096268)},
        {VM_C(2.458388057537377), VM_C(3.1958700654394143e-10), VM_C(-2.589137242663128),
         VM_C(1.5206249533558837e-12), VM_C(3.9453024864196777), VM_C(8.870598428335426e-09), VM_C(-7.30859375),
         VM_C(0.0011621316776115117), VM_C(15.142410278320312), VM_C(-3.661931022144613e-06),
         VM_C(-33.56094033694419), VM_C(77.64253467351422), VM_C(-184.9566634907376), VM_C(450.01612867375326),
         VM_C(-1112.6135828030247), VM_C(2785.5734925581996), VM_C(-7045.181847351141),
         VM_C(18070.358700058467), VM_C(-46413.10856679214)},
        {VM_C(2.3811208568513393), VM_C(-4.3722812720431884e-10), VM_C(-2.3622631463149446),
         VM_C(-1.2551230255063407e-12), VM_C(3.3397194147109985), VM_C(2.27236017674481e-08), VM_C(-5.69921875),
         VM_C(-0.0012671740458013976), VM_C(10.864639282226562), VM_C(5.428470841603015e-06),
         VM_C(-22.14239082874157), VM_C(47.11055252332709), VM_C(-103.22330184124286), VM_C(231.0280247532738),
         VM_C(-525.4514133942547), VM_C(1210.2327706551507), VM_C(-2815.9090916350087), VM_C(6638.799347956145),
         VM_C(-15686.96240964093)},
        {VM_C(2.310397354885936), VM_C(4.4943816132307236e-10), VM_C(-2.1690028555094614),
         VM_C(-3.0783638039106183e-12), VM_C(2.8628164529800415), VM_C(-2.5583690594056026e-08), VM_C(-4.53125),
         VM_C(-0.0017327659072434464), VM_C(7.9983978271484375), VM_C(1.9241405468772697e-06),
         VM_C(-15.08634941208909), VM_C(29.709247137296842), VM_C(-60.25911522122658), VM_C(124.85952509436666),
         VM_C(-262.9214083418343), VM_C(560.6784331117852), VM_C(-1207.876384583304), VM_C(2634.8666661904936),
         VM_C(-5764.636354385284)},
        {VM_C(2.2452806038782), VM_C(1.5929193583224803e-11), VM_C(-2.002447675258736),
         VM_C(-1.1918382274065734e-12), VM_C(2.480501174926758), VM_C(3.6031066842354633e-08), VM_C(-3.6640625),
         VM_C(-0.00013660238446397286), VM_C(6.019432067871094), VM_C(3.0679851098781218e-06),
         VM_C(-10.566113124379067), VM_C(19.36536050048058), VM_C(-36.560543713436246), VM_C(70.519329850864),
         VM_C(-138.24030764786906), VM_C(274.4485002912677), VM_C(-550.4479429683332), VM_C(1117.2897640245117),
         VM_C(-2275.7912322351303)},
        {VM_C(2.185020098462701), VM_C(2.7877055985495364e-10), VM_C(-1.8574636568991991),
         VM_C(7.748472886003439e-14), VM_C(2.1692839860916138), VM_C(1.1799983102101875e-08), VM_C(-3.00390625),
         VM_C(-0.0003410611792930962), VM_C(4.617340087890625), VM_C(-1.311959866136205e-06),
         VM_C(-7.579132163491498), VM_C(12.989870488169153), VM_C(-22.935822624351733), VM_C(41.37828055920222),
         VM_C(-75.87315650410629), VM_C(140.90305008340616), VM_C(-264.3573180102745), VM_C(501.728185710565),
         VM_C(-956.0015902139925)},
        {VM_C(2.102429259568453), VM_C(-8.077842563041762e-11), VM_C(-1.6721612590772565),
         VM_C(9.554872956093813e-13), VM_C(1.8007213473320007), VM_C(9.801283481440577e-09), VM_C(-2.28125),
         VM_C(-0.00043303059970795874), VM_C(3.198528289794922), VM_C(-5.475212897755724e-07),
         VM_C(-4.784629973738347), VM_C(7.472772359459962), VM_C(-12.025358494248854), VM_C(19.775197584239713),
         VM_C(-33.055383179012274), VM_C(55.96157541211502), VM_C(-95.72132853472863), VM_C(166.84665767150673),
         VM_C(-289.87326983903307)},
        {VM_C(2.004440844990313), VM_C(-4.5010771996226664e-10), VM_C(-1.4710127689540968),
         VM_C(-1.8072160687858196e-12), VM_C(1.4376887083053589), VM_C(-1.4029519873472607e-08),
         VM_C(-1.6376953125), VM_C(-0.00027706738645310783), VM_C(2.056182861328125),
         VM_C(-5.616458750896704e-07), VM_C(-2.7507567275484277), VM_C(3.8414042271742685),
         VM_C(-5.5279349969667395), VM_C(8.1304038333738), VM_C(-12.156675369508667), VM_C(18.411441765190272),
         VM_C(-28.174077697187347), VM_C(43.84389519643396), VM_C(-68.14882879730841)},
        {VM_C(1.9177475841715932), VM_C(-1.9997115215481755e-10), VM_C(-1.3086786530438985),
         VM_C(1.6026422324320387e-12), VM_C(1.172825574874878), VM_C(-1.359834957426624e-08), VM_C(-1.21484375),
         VM_C(-0.0003492524285075808), VM_C(1.3818416595458984), VM_C(-6.872390288395432e-07),
         VM_C(-1.672148490159854), VM_C(2.1114992966434434), VM_C(-2.7476562871197405),
         VM_C(3.6548373291234326), VM_C(-4.942879942200957), VM_C(6.771814195753297), VM_C(-9.374360314146198),
         VM_C(13.17750883114574), VM_C(-18.53015252836741)},
        {VM_C(1.8402594467625022), VM_C(2.0249718952219971e-10), VM_C(-1.1750830864621093),
         VM_C(3.4135389345175896e-13), VM_C(0.9737151265144348), VM_C(7.838856940231847e-09),
         VM_C(-0.92626953125), VM_C(0.00023426604361437487), VM_C(0.962921142578125),
         VM_C(-5.9133252239829695e-09), VM_C(-1.0638615813542538), VM_C(1.2259680921838525),
         VM_C(-1.4558498195354896), VM_C(1.7673865438206877), VM_C(-2.181731462041832), VM_C(2.728508285359651),
         VM_C(-3.4481530399745504), VM_C(4.420051305238651), VM_C(-5.674456749708208)},
        {VM_C(1.7704079924151301), VM_C(2.6181450039848477e-11), VM_C(-1.0633550278726034),
         VM_C(-3.364736394299506e-13), VM_C(0.8203088045120239), VM_C(-8.14803002160217e-09),
         VM_C(-0.7216796875), VM_C(0.0001108432531028098), VM_C(0.6915140151977539),
         VM_C(2.9924920657377865e-07), VM_C(-0.7030076017095191), VM_C(0.7450335571706033),
         VM_C(-0.8135644938649125), VM_C(0.9082656052187542), VM_C(-1.0311707468404132),
         VM_C(1.1861554969375157), VM_C(-1.3788502991192686), VM_C(1.6244718612624807),
         VM_C(-1.9184651339803893)},
        {VM_C(1.7069863928481936), VM_C(1.2317388542324716e-10), VM_C(-0.9686466927578294),
         VM_C(-8.279890501249515e-13), VM_C(0.6996612846851349), VM_C(1.3190958932255998e-08),
         VM_C(-0.57275390625), VM_C(-0.0001503992077719784), VM_C(0.5093860626220703),
         VM_C(3.8547769831121483e-07), VM_C(-0.4796712194666632), VM_C(0.47056519124915314),
         VM_C(-0.4755809964528156), VM_C(0.4914101522145601), VM_C(-0.5164101564199564),
         VM_C(0.5498886327854214), VM_C(-0.5917615430237934), VM_C(0.6450016691606806),
         VM_C(-0.7052326221747047)},
        {VM_C(1.6490464988164604), VM_C(1.4092343928193297e-10), VM_C(-0.8874393933547253),
         VM_C(-2.528730806555513e-13), VM_C(0.6031083464622498), VM_C(2.189236526603104e-09),
         VM_C(-0.462158203125), VM_C(-6.906982244360925e-05), VM_C(0.3834667205810547),
         VM_C(-9.968686271711333e-08), VM_C(-0.33637856935369204), VM_C(0.307188734190347),
         VM_C(-0.28894367051935693), VM_C(0.2778620518313248), VM_C(-0.27177003940302646),
         VM_C(0.2693613149724727), VM_C(-0.2698285538482113), VM_C(0.2736310673498627),
         VM_C(-0.2785177170135954)},
        {VM_C(1.5958301280625165), VM_C(7.69171178984451e-11), VM_C(-0.8171171152152965),
         VM_C(1.5509128100481976e-13), VM_C(0.5246719419956207), VM_C(8.270597045298386e-09),
         VM_C(-0.378173828125), VM_C(3.264455219463898e-05), VM_C(0.2941460609436035),
         VM_C(-2.0350739001975062e-07), VM_C(-0.24155078309886438), VM_C(0.20635129762942256),
         VM_C(-0.1815167284418184), VM_C(0.16323414616929355), VM_C(-0.14930603573692017),
         VM_C(0.13839877507572465), VM_C(-0.1296676858274509), VM_C(0.12293726084348575),
         VM_C(-0.117045268979489)},
        {VM_C(1.5235462966375053), VM_C(-1.2886668387630985e-11), VM_C(-0.727827285798412),
         VM_C(-1.0217751327455818e-13), VM_C(0.4320553094148636), VM_C(5.25174499193368e-09),
         VM_C(-0.2861328125), VM_C(3.470758866239467e-05), VM_C(0.20365238189697266),
         VM_C(3.252511456354899e-08), VM_C(-0.15268466389224913), VM_C(0.11894494932474993),
         VM_C(-0.09536559352129662), VM_C(0.07815535992883661), VM_C(-0.06514827183541826),
         VM_C(0.05503631242369706), VM_C(-0.046999257487729075), VM_C(0.040915197290837244),
         VM_C(-0.0355132551090007)},
        {VM_C(1.4388054376468062), VM_C(-7.04474549608874e-11), VM_C(-0.6318001541621925),
         VM_C(-8.80018187608036e-13), VM_C(0.3412606567144394), VM_C(-7.212091968073193e-09),
         VM_C(-0.2042236328125), VM_C(4.1587680610485594e-05), VM_C(0.1307060718536377),
         VM_C(-1.0142484379213166e-07), VM_C(-0.08787019289171061), VM_C(0.061282373736543154),
         VM_C(-0.04395293481649985), VM_C(0.03221290353535262), VM_C(-0.02401165321698189),
         VM_C(0.01814022373011364), VM_C(-0.013854397242689116), VM_C(0.010764983943842649),
         VM_C(-0.00835760518341378)},
        {VM_C(1.3647932666353881), VM_C(-1.1412976847678343e-10), VM_C(-0.5551319894857443),
         VM_C(1.7007059522883908e-13), VM_C(0.2754291743040085), VM_C(5.062714522143538e-09),
         VM_C(-0.1505126953125), VM_C(2.0460565836481268e-05), VM_C(0.08761632442474365),
         VM_C(4.843781452732208e-08), VM_C(-0.05342725032689799), VM_C(0.033743858299197294),
         VM_C(-0.021898365172745352), VM_C(0.014515892499805274), VM_C(-0.00978506735286864),
         VM_C(0.006685153923027192), VM_C(-0.0046174324161999784), VM_C(0.003239959921404032),
         VM_C(-0.002275114409322478)},
        {VM_C(1.2994312979280949), VM_C(1.351882297858641e-11), VM_C(-0.4927040895308892),
         VM_C(-1.3683568870972404e-13), VM_C(0.22627606242895126), VM_C(1.305123317913712e-09),
         VM_C(-0.1138916015625), VM_C(1.255884387467134e-05), VM_C(0.06085127592086792),
         VM_C(-1.451458574211298e-08), VM_C(-0.033973749717431355), VM_C(0.019615519649488076),
         VM_C(-0.011626502976192107), VM_C(0.00703569952421879), VM_C(-0.004328736981299801),
         VM_C(0.0026990880049220754), VM_C(-0.0017014422088708497), VM_C(0.001088409261990386),
         VM_C(-0.0006975974769562036)}};
#else
    VM_TABLE vm_real table[VMI_PERIOD_ROWS][VMI_PERIOD_COLUMNS] = {
        {VM_C(3.1200943), VM_C(8.50726991e-8), VM_C(-5.41552734), VM_C(1.0239135e-5), VM_C(16.0),
         VM_C(-0.32420516), VM_C(-57.8167763), VM_C(240.485504), VM_C(-1071.72986), VM_C(4968.00928)},
        {VM_C(3.03909683), VM_C(4.73515804e-8), VM_C(-4.96484375), VM_C(2.25261319e-4), VM_C(13.0),
         VM_C(0.281128556), VM_C(-45.0626335), VM_C(172.368393), VM_C(-706.289673), VM_C(3011.70117)},
        {VM_C(2.96460485), VM_C(8.21544504e-8), VM_C(-4.58007813), VM_C(-7.43694982e-5), VM_C(11.0),
         VM_C(0.396870911), VM_C(-35.8059387), VM_C(126.763733), VM_C(-480.691589), VM_C(1897.63916)},
        {VM_C(2.89569306), VM_C(-2.47340672e-8), VM_C(-4.24853516), VM_C(1.10910616e-4), VM_C(10.0),
         VM_C(-0.112594992), VM_C(-28.9247837), VM_C(95.3025742), VM_C(-336.304596), VM_C(1235.90454)},
        {VM_C(2.83162045), VM_C(-8.2044302e-8), VM_C(-3.95922852), VM_C(-3.89035122e-5), VM_C(9.0),
         VM_C(-0.340632647), VM_C(-23.7029419), VM_C(73.031395), VM_C(-240.979691), VM_C(828.333923)},
        {VM_C(2.7432971), VM_C(-2.93034486e-8), VM_C(-3.58911133), VM_C(1.20393634e-4), VM_C(7.0),
         VM_C(0.205826521), VM_C(-17.9923954), VM_C(50.5185356), VM_C(-152.386261), VM_C(477.557068)},
        {VM_C(2.6376729), VM_C(1.15010906e-7), VM_C(-3.18579102), VM_C(-2.86850991e-5), VM_C(6.0),
         VM_C(-0.225306496), VM_C(-12.9130545), VM_C(32.4204826), VM_C(-87.3772659), VM_C(244.915939)},
        {VM_C(2.54339004), VM_C(-8.01007403e-8), VM_C(-2.85913086), VM_C(-1.99543101e-5), VM_C(4.5),
         VM_C(0.230580702), VM_C(-9.5823698), VM_C(21.7559929), VM_C(-52.9888191), VM_C(134.330994)},
        {VM_C(2.45838809), VM_C(-3.22767022e-8), VM_C(-2.58911133), VM_C(-2.5914831e-5), VM_C(4.0),
         VM_C(-0.0546975024), VM_C(-7.30742216), VM_C(15.1423826), VM_C(-33.6401062), VM_C(77.8351669)},
        {VM_C(2.38112092), VM_C(-6.37671604e-8), VM_C(-2.36230469), VM_C(4.15410177e-5), VM_C(3.25),
         VM_C(0.0897194371), VM_C(-5.70048046), VM_C(10.8646326), VM_C(-22.1865616), VM_C(47.2094154)},
        {VM_C(2.31039739), VM_C(-3.12155279e-8), VM_C(-2.16894531), VM_C(-5.75431077e-5), VM_C(2.75),
         VM_C(0.112816431), VM_C(-4.53297949), VM_C(7.99839306), VM_C(-15.1121292), VM_C(29.7626667)},
        {VM_C(2.2452805), VM_C(9.96674459e-8), VM_C(-2.00244141), VM_C(-6.26906831e-6), VM_C(2.5),
         VM_C(-0.0194987897), VM_C(-3.66419721), VM_C(6.01943159), VM_C(-10.5817518), VM_C(19.395525)},
        {VM_C(2.18502021), VM_C(-1.09617297e-7), VM_C(-1.85742188), VM_C(-4.17819356e-5), VM_C(2.25),
         VM_C(-0.080715999), VM_C(-3.004246), VM_C(4.61733675), VM_C(-7.5889411), VM_C(13.0075674)},
        {VM_C(2.10242915), VM_C(1.07952637e-7), VM_C(-1.67211914), VM_C(-4.21196819e-5), VM_C(1.75),
         VM_C(0.0507213585), VM_C(-2.28167295), VM_C(3.19851112), VM_C(-4.80525017), VM_C(7.50668478)},
        {VM_C(2.00444078), VM_C(6.00858598e-8), VM_C(-1.47106934), VM_C(5.65664159e-5), VM_C(1.5),
         VM_C(-0.0623113066), VM_C(-1.63796771), VM_C(2.05617547), VM_C(-2.76022935), VM_C(3.85533738)},
        {VM_C(1.91774762), VM_C(-3.27962617e-8), VM_C(-1.30871582), VM_C(3.71669885e-5), VM_C(1.125),
         VM_C(0.04782556), VM_C(-1.21519065), VM_C(1.38183796), VM_C(-1.67685449), VM_C(2.11775947)},
        {VM_C(1.84025943), VM_C(1.41723362e-8), VM_C(-1.17504883), VM_C(-3.42584863e-5), VM_C(1.0),
         VM_C(-0.026284866), VM_C(-0.926034033), VM_C(0.962919652), VM_C(-1.06635416), VM_C(1.22899425)},
        {VM_C(1.77040803), VM_C(-4.18833359e-8), VM_C(-1.06335449), VM_C(-5.35768493e-7), VM_C(0.8125),
         VM_C(0.0078087966), VM_C(-0.721568167), VM_C(0.691513538), VM_C(-0.704400122), VM_C(0.74658823)},
        {VM_C(1.70698643), VM_C(-3.43357627e-8), VM_C(-0.96862793), VM_C(-1.87631194e-5), VM_C(0.6875),
         VM_C(0.0121612977), VM_C(-0.572903931), VM_C(0.509386063), VM_C(-0.480485052), VM_C(0.471406162)},
        {VM_C(1.64904654), VM_C(-4.13029326e-8), VM_C(-0.887451172), VM_C(1.17784903e-5), VM_C(0.625),
         VM_C(-0.0218916517), VM_C(-0.462227017), VM_C(0.383466393), VM_C(-0.336872935), VM_C(0.307664156)},
        {VM_C(1.59583008), VM_C(4.52460611e-8), VM_C(-0.817138672), VM_C(2.15566415e-5), VM_C(0.5),
         VM_C(0.0246719494), VM_C(-0.378141046), VM_C(0.294145733), VM_C(-0.241861299), VM_C(0.206630558)},
        {VM_C(1.52354634), VM_C(-4.14567403e-8), VM_C(-0.727844238), VM_C(1.69518589e-5), VM_C(0.4375),
         VM_C(-0.005444685), VM_C(-0.286096811), VM_C(0.203651369), VM_C(-0.15333876), VM_C(0.119481057)},
        {VM_C(1.43880546), VM_C(-2.33535111e-8), VM_C(-0.631774902), VM_C(-2.52521077e-5), VM_C(0.34375),
         VM_C(-0.00248935027), VM_C(-0.204181463), VM_C(0.130705535), VM_C(-0.0881714523), VM_C(0.0615031868)},
        {VM_C(1.3647933), VM_C(-3.41074049e-8), VM_C(-0.555114746), VM_C(-1.72435357e-5), VM_C(0.28125),
         VM_C(-0.00582082057), VM_C(-0.150491938), VM_C(0.0876161754), VM_C(-0.0535772741), VM_C(0.0338433124)},
        {VM_C(1.29943132), VM_C(-2.6063514e-8), VM_C(-0.492706299), VM_C(2.20922107e-6), VM_C(0.21875),
         VM_C(0.00752606383), VM_C(-0.113878883), VM_C(0.0608511679), VM_C(-0.0340533741), VM_C(0.0196637064)}};
#endif
    return VM_READ(table[row][column]);
}

/* The quarter period as the sum head + middle + low. The numbers head and middle have few digits: their products with a
   whole number below 2^20 are exact (in float below 2^13, and for head < 2 below 2^14). rough is the sum in one word,
   with a relative error below 2^-27 (float 2^-23). early approximates the sum with a relative error below 2^-13 and is
   ready sooner. */
typedef struct VM_TAG(vmi_period) {
    vm_real head, middle, low, rough, early;
} vmi_period;

/* VMI_PERIOD_CUT is the number of last digits of k' that are set to 0 in the head of k'. Each of the other constants
   rounds a number: the constant is added to the number and subtracted again. VMI_SQUARE_GRID rounds t^2 to a multiple
   of 2^-21, VMI_SLOPE_GRID c_1 to a multiple of 2^-16, and VMI_MIDDLE_GRID the sum of c_1 t, c_2 t^2, ... to a multiple
   of 2^-36. In float VMI_MIDDLE_GRID rounds the sum to a multiple of 2^-14, and VMI_HEAD_GRID c_0 to a multiple of
   2^-9. */
#if VM_MANT_DIG > 24
#define VMI_PERIOD_CUT 34
#define VMI_SQUARE_GRID VM_C(3221225472.0)
#define VMI_SLOPE_GRID VM_C(103079215104.0)
#define VMI_MIDDLE_GRID VM_C(98304.0)
#else
#define VMI_PERIOD_CUT 9
#define VMI_HEAD_GRID VM_C(24576.0)
#define VMI_MIDDLE_GRID VM_C(768.0)
#endif

/* Returns K for 1 - m = m1 + m1_lo, a number in two words, where kp is k' in one word and VMI_IN_PERIOD_TABLE(kp) is 1.
   The relative error is below 2^-71 (float 2^-36).
   Method: in two words k' is kp + kp_lo. The variable t is kp minus the middle of the piece; t does not contain kp_lo.
   t is the sum of head, which has at most 14 binary digits (float 10), and kp_tail. The products b1, b2, ... are exact,
   since their factors have few digits: b1, b2 and b3 are the first words of c_1, c_2 and c_3 times head, head^2 and
   head^3; b4 is the first word of c_4 times g^2, where g is t^2 with few digits; b5 is c_1 with few digits times
   kp_tail (float: only b1 and b2). The sums in which K.middle is subtracted are exact, too. All other terms are so
   small that one word is enough for them. The effect of kp_lo is kp_lo times the derivative of the polynomial; of this
   derivative, the terms up to those that come from c_5 t^5 (float c_4 t^4) are used. */
VM_INLINE vmi_period vmi_period_by_table(vm_real m1, vm_real m1_lo, vm_real kp)
{
    const vmi_bits bits = vmi_to_bits(kp), half = (vmi_bits)1 << (VMI_STORED_DIG - 4);
    const vmi_bits row = (bits >> (VMI_STORED_DIG - 3)) - (8 * (VMI_BIAS - 3) + 3);
    const vm_real middle = vmi_from_bits((bits & ~(2 * half - 1)) | half);
    const vm_real kp_head = vmi_from_bits(bits & ~(((vmi_bits)1 << VMI_PERIOD_CUT) - 1)), kp_tail = kp - kp_head;
#if VM_MANT_DIG > 24
    const vm_real residual = ((m1 - kp_head * kp_head) - 2 * kp_head * kp_tail) - (kp_tail * kp_tail - m1_lo);
#else
    const vm_real residual = vmi_root_residual(m1, kp) + m1_lo;
#endif
    const vm_real kp_lo = residual * (VM_C(0.5) / kp);
    const vm_real head = kp_head - middle, t = kp - middle, tt = t * t, hh = head * head;
    const vm_real c0 = vmi_period_constant(row, 0), c0_lo = vmi_period_constant(row, 1);
    const vm_real c1 = vmi_period_constant(row, 2), c1_lo = vmi_period_constant(row, 3);
    const vm_real c2 = vmi_period_constant(row, 4), c2_lo = vmi_period_constant(row, 5);
    const vm_real b1 = c1 * head, b2 = c2 * hh;
    vmi_period K;
#if VM_MANT_DIG > 24
    const vm_real c3 = vmi_period_constant(row, 6), c3_lo = vmi_period_constant(row, 7);
    const vm_real c4 = vmi_period_constant(row, 8), c4_lo = vmi_period_constant(row, 9);
    const vm_real c5 = vmi_period_constant(row, 10), t4 = tt * tt;
    const vm_real g = vmi_rounded(tt + VMI_SQUARE_GRID) - VMI_SQUARE_GRID; /* the head of t^2 */
    const vm_real c1_head = vmi_rounded(c1 + VMI_SLOPE_GRID) - VMI_SLOPE_GRID, c1_rest = (c1 - c1_head) + c1_lo;
    const vm_real b3 = c3 * (head * hh), b4 = c4 * g * g, b5 = c1_head * kp_tail;
    const vm_real b = b1 + (b2 + (b3 + (b4 + b5)));
    const vm_real p56 = c5 + t * vmi_period_constant(row, 11);
    const vm_real p78 = vmi_period_constant(row, 12) + t * vmi_period_constant(row, 13);
    const vm_real p9A = vmi_period_constant(row, 14) + t * vmi_period_constant(row, 15);
    const vm_real pBC = vmi_period_constant(row, 16) + t * vmi_period_constant(row, 17);
    const vm_real p = (p56 + tt * p78) + t4 * ((p9A + tt * pBC) + t4 * vmi_period_constant(row, 18));
    const vm_real words = (c0_lo + (c1_lo * head + (c2_lo + c3_lo * head) * hh)) + c4_lo * (g * g);
    const vm_real rest4 = (c4 + c4_lo) * ((tt - g) * (tt + g)), slope45 = tt * t * (4 * c4 + 5 * t * c5);
    const vm_real slope3 = (c3 + c3_lo) * (3 * head * t + kp_tail * kp_tail);
    const vm_real slope = (c2 + c2_lo) * (head + t) + slope3; /* (terms of c_2, c_3 at t less those at head)/kp_tail */
    const vm_real rest1 = kp_tail * (c1_rest + slope) + kp_lo * (c1 + slope + slope45);
    K.middle = vmi_rounded(b + VMI_MIDDLE_GRID) - VMI_MIDDLE_GRID;
    K.low = (((((b1 - K.middle) + b2) + b3) + b4) + b5) + (((words + rest4) + t4 * t * p) + rest1);
    K.head = c0;
    K.early = c0 + (b1 + b2);
    K.rough = c0 + (b + ((words + rest4) + (rest1 + t4 * (t * c5))));
#else
    const vm_real p34 = vmi_period_constant(row, 6) + t * vmi_period_constant(row, 7);
    const vm_real p56 = vmi_period_constant(row, 8) + t * vmi_period_constant(row, 9);
    const vm_real rest = tt * (t * (p34 + tt * p56)), slope = (c1 + c1_lo) + (c2 + c2_lo) * (head + t);
    const vm_real words = c0_lo + (c1_lo * head + c2_lo * hh), tail = kp_tail + kp_lo;
    const vm_real slope34 = tt * (3 * vmi_period_constant(row, 6) + 4 * t * vmi_period_constant(row, 7));
    const vm_real c0_head = vmi_rounded(c0 + VMI_HEAD_GRID) - VMI_HEAD_GRID, c0_mid = c0 - c0_head;
    const vm_real sum = c0_mid + (b1 + (b2 + rest));
    K.middle = vmi_rounded(sum + VMI_MIDDLE_GRID) - VMI_MIDDLE_GRID;
    K.low = (((b1 - K.middle) + c0_mid) + b2) + ((rest + words) + (tail * slope + kp_lo * slope34));
    K.head = c0_head;
    K.early = c0 + (b1 + b2);
    K.rough = c0_head + (sum + (words + tail * slope));
#endif
    return K;
}

#endif
