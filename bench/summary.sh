#!/bin/sh
# The lines of the bench programs that answer most questions, with their peers: some 25 rows.
# usage: summary.sh FOLDER [markdown], FOLDER with the CSV files of the programs
folder=$1 style=$2
# what it is @ topic @ job @ route @ knob, * for any @ route of the peer
rows='sin, arguments in random order @ jacobi @ sin; |x| < 10; random @ sin @ @
K @ jacobi @ K; 0 < m < 1 @ jacobi_K @ @ gsl_sf_ellint_Kcomp
E @ jacobi @ E; 0 < m < 1 @ jacobi_E @ @ gsl_sf_ellint_Ecomp
sn, cn, dn @ jacobi @ sncndn; |u| < K/2; 0 < m < 0.5 @ jacobi_sncndn @ @ gsl_sf_elljac_e
sn, cn, dn @ jacobi @ sncndn; |u| < 2K; 0.5 < m < 1 @ jacobi_sncndn @ @ gsl_sf_elljac_e
sn, cn, dn @ jacobi @ sncndn; |u| < 1e9; 0 < m < 0.5 @ jacobi_sncndn @ @ gsl_sf_elljac_e
sn, cn, dn, m prepared @ jacobi @ sncndn; |u| < 2K; m = 0.5 @ jacobi_plan_sncndn @ @ gsl_sf_elljac_e
sn, cn, dn, m prepared, arrays, -O3 -march=native @ jacobi_wide @ sncndn; |u| < 2K; m = 0.5 @ jacobi_plan_sncndn_array @ @ gsl_sf_elljac_e
modulus solver @ jacobi @ m of k'"'"'K = c; 1.32 < c < 1.85 @ jacobi_solve_kpK @ @
Pi_alpha @ ateb @ Pi; 0 < alpha < 5 @ ateb_pi @ @
sa, ca, any alpha @ ateb @ saca; |s| < 10; alpha = 3 @ ateb_saca @ @ gsl_cdf_beta_Pinv
sa, ca, alpha prepared @ ateb @ saca; |s| < 10; alpha = 3 @ ateb_plan_saca @ @ gsl_cdf_beta_Pinv
sa, ca, alpha prepared, to 1e-4 @ ateb @ saca; |s| < 10; alpha = 3 @ ateb_plan_saca @ 1e-4 @ gsl_cdf_beta_Pinv
sa, ca, alpha prepared, arrays, -O3 -march=native @ ateb_wide @ saca; |s| < 10; alpha = 3 @ ateb_plan_saca_array @ @ gsl_cdf_beta_Pinv
sa, ca, alpha prepared @ ateb @ saca; |s| < 10; alpha = 1.333 @ ateb_plan_saca @ @ gsl_cdf_beta_Pinv
incomplete beta function @ ateb @ I_x; 0.5 < a; b < 5 @ ateb_beta_inc @ @ gsl_sf_beta_inc
inverse of this function @ ateb @ x of I_x; 0.5 < a; b < 5 @ ateb_beta_inc_inv @ @ gsl_cdf_beta_Pinv
x'"''"' = -x^3 @ integrators @ cubic; 1000 steps @ rk4_solve @ @
x'"''"' = -x^3 @ integrators @ cubic to 1e-6 @ rk45_solve @ * @ gsl_rkf45
x'"''"' = -x^3 @ integrators @ cubic to 1e-10 @ rk87_solve @ * @ gsl_rk8pd
Arenstorf'"'"'s orbit @ integrators @ orbit to 1e-8 @ rk87_solve @ * @ gsl_rk8pd
x(300), mass 1 + 0.01 t @ oscillator @ alpha=3 psi0=0.7 eps=0.01 @ vm_osc_within @ 1e-04 @
attitude after 1e6 turns @ rotation @ triaxial 1e6 @ exact @ @
a right-hand side with 3 effects @ scenes @ 3: and Van der Pol @ scene @ @
that right-hand side by inline functions @ scenes @ 3: and Van der Pol @ inline functions @ @
a right-hand side, 1 stream @ streams @ space @ vm_flow_rhs @ 1 @'
cat "$folder"/*.csv | awk -F, -v rows="$rows" -v style="$style" '
    function digits(x) {return x < 9.995 ? sprintf("%.2f", x) : x < 99.95 ? sprintf("%.1f", x) : sprintf("%.0f", x)}
    function line(a, b, c, d, e, f, g, h, i) {
        if (style && h != "") h = "`" h "`"
        if (style) printf "| %s | %s | `%s` | %s | %s | %s | %s | %s | %s |\n", a, b, c, d, e, f, g, h, i
        else printf "%-36s %-33s %-25s %9s %9s %16s %7s  %-20s %s\n", a, b, c, d, e, f, g, h, i
    }
    BEGIN {
        n = split(rows, row, "\n")
        for (i = 1; i <= n; i++) {
            split(row[i], field, / *@ */)
            what[i] = field[1]; topic[i] = field[2]; job[i] = field[3]
            route[i] = field[4]; knob[i] = field[5]; peer[i] = field[6]
        }
    }
    {
        for (i = 1; i <= n; i++) {
            if ($1 != topic[i] || $2 != job[i]) continue
            if ($3 == route[i] && (knob[i] == "*" || $4 == knob[i])) {
                found[i] = 1; error[i] = $5; ns[i] = $6; ratio[i] = $7; spread[i] = $8; beside[i] = $9
            }
            if ($3 == peer[i] && peer[i] != "") {peer_error[i] = $5; peer_ratio[i] = $7; peer_beside[i] = $9}
        }
    }
    END {
        if (style) print "| what | of which | by | error | ns | ratio | spread | peer | its error, ratio |\n|---|---|---|---|---|---|---|---|---|"
        else line("what", "of which", "by", "error", "ns", "ratio", "spread", "peer", "its error, ratio")
        for (i = 1; i <= n; i++) {
            if (!found[i]) continue
            gsub(/;/, ",", job[i])
            if (style) gsub(/[|]/, "\\\\|", job[i])
            theirs = ""
            if (peer_ratio[i] != "") {
                theirs = peer_error[i] ", " digits(peer_ratio[i]) " x"
                if (peer_ratio[i] < ratio[i] && peer_error[i] + 0 <= error[i] + 0 && peer_beside[i] == beside[i])
                    theirs = theirs ": the peer wins"
            }
            line(what[i], job[i], route[i] (knob[i] != "" && knob[i] != "*" ? " " knob[i] : ""), error[i], digits(ns[i]),
                 digits(ratio[i]) " x " beside[i], sprintf("%.1f %%", 100*spread[i]), peer_ratio[i] != "" ? peer[i] : "", theirs)
        }
    }'
