# SPDX-License-Identifier: GPL-3.0-or-later
"""Schemes on knots against PARI/GP: stencils from the splines themselves, spectra of junctions, the paper's appendix."""

import os
import random
import tempfile
import unittest
from fractions import Fraction

from mpmath import mp

from support import ProgramTest, pari, to_pari

# NULIFS of nuli (2.4)-(2.7), with the index of phi corrected, evaluated as written: t maps m to the knot t_m.
SPLINES = r"""
bs(t,n,m,x,s)={my(a,b);if(n==1,return(if(m==s,1,0)));if(m>s||m+n-1<s,return(0));a=t(m+n-1)-t(m);b=t(m+n)-t(m+1);if(a==0,0,(x-t(m))/a*bs(t,n-1,m,x,s))+if(b==0,0,(t(m+n)-x)/b*bs(t,n-1,m+1,x,s));}
cf(t,n,rho,mu,i,j)={my(m=2*i+j,r=floor(m/2),phi=1,psi=1,y='y);for(l=r+mu-rho+1,r+mu,if(l!=i,phi*=(y-t(2*l))/(t(2*i)-t(2*l))));for(q=1,n-1,psi*=(y-t(m+q)));sum(k=0,rho-1,(-1)^k*k!*polcoef(phi,k,y)*(n-1-k)!*polcoef(psi,n-1-k,y))/(n-1)!;}
u(t,n,rho,mu,i,x,s)={sum(j=-2*mu,-2*mu+2*rho-1,my(b=bs(t,n,2*i+j,x,s));if(b==0,0,b*cf(t,n,rho,mu,i,j)));}
ell(t,n,v,i,x,s)={my(N=n-3,A,B);A=matrix(N,N,r,c,bs(t,n,2*i-2*v+c-1,t(2*(i-v+r)),2*(i-v+r)));B=A;for(c=1,N,B[v,c]=bs(t,n,2*i-2*v+c-1,x,s));matdet(B)/matdet(A);}
v(t,n,rho,mu,i,x,s)={if(n==3,return(u(t,n,rho,mu,i,x,s)));my(tau=min(mu,n-3),g=mu-tau+1);ell(t,n,tau,i,x,s)+u(t,n,rho,g,i,x,s)-sum(k=1,n\2+rho-1,my(q=i-g+k,w=u(t,n,rho,g,i,t(2*q),2*q));if(w==0,0,w*ell(t,n,tau,q,x,s)));}
knots(f,d,l)={my(D=e->if(e>=f&&e<f+#d,d[e-f+1],1),L=e->if(e>=f&&e<f+#l,l[e-f+1],1/2),X=i->if(i>=0,sum(k=0,i-1,D(k)),-sum(k=i,-1,D(k))));m->my(i=floor(m/2));if(m%2==0,X(i),X(i)+L(i)*D(i));}
rule(n,rho,mu,f,d,l)={my(t=knots(f,d,l));vector(2*mu,h,v(t,n,rho,mu,h-mu,t(2)/2,if(t(1)>=t(2)/2,0,1)));}
"""


def brackets(values):
    return "[" + ",".join(str(v) for v in values) + "]"


class Stencils(ProgramTest):
    def test_against_the_splines(self):
        source = random.Random(3)
        for scheme, order, mu in (("nuli4", 3, 2), ("nuli6", 4, 3)):
            code, ours = SPLINES, []
            for _ in range(12):
                d = [Fraction(source.randint(1, 20), source.randint(1, 9)) for _ in range(2 * mu - 1)]
                # 1/2 and the neighbourhood of 0 and 1; 0 and 1 themselves are limits, see tests/symbolic.
                lam = [source.choice([Fraction(1, 2), Fraction(source.randint(1, 29), 30)]) for _ in range(2 * mu - 1)]
                own = lam[mu - 1:mu] if mu == 2 else lam[1:4]
                d_text = brackets(d)
                document = self.twoscale_json("stencil", scheme, "--at", f"d={d_text},lambda={brackets(own)}")
                self.assertEqual(document["lowest"], 1 - mu)
                ours.append(brackets(document["coefficients"]))
                code += f"print(rule({order},{order},{mu},{1 - mu},{d_text},{brackets(lam)})=={ours[-1]});\n"
            self.assertEqual(pari(code).split(), ["1"] * 12)

    def test_rule_of_any_order(self):
        """2mu points, with edge parameters: the definition; polynomials of degree < rho; edges beyond are not read."""
        source = random.Random(7)
        code, expected = SPLINES, []
        for order, rho, mu in ((5, 5, 4), (6, 5, 5), (7, 6, 6)):
            last = max(mu - 1, (3 * order - 10) // 2)
            d = [Fraction(source.randint(1, 9), source.randint(1, 5)) for _ in range(1 - mu, last + 1)]
            lam = [Fraction(source.randint(1, 9), 10) for _ in range(3 - order, (3 * order - 10) // 2 + 1)]
            at = f"d={brackets(d)},lambda={brackets(lam)}"
            weights = [Fraction(c) for c in self.twoscale_json("stencil", f"nuli:n={order}", "--at", at)["coefficients"]]
            outer = [Fraction(1, 3)] * (3 - order - (1 - mu))
            code += f"r=rule({order},{rho},{mu},{1 - mu},{brackets(d)},{brackets(outer + lam)});\n"
            code += f"print(r=={brackets(weights)});\n"
            lam[mu // 2] += Fraction(1, 20)
            code += f"print(r==rule({order},{rho},{mu},{1 - mu},{brackets(d)},{brackets(outer + lam)}));\n"
            expected += ["1", "0"]
        self.assertEqual(pari(code).split(), expected)

    def test_precision_of_any_order(self):
        source = random.Random(8)
        for order, rho, mu in ((6, 5, 5), (7, 6, 6), (8, 8, 8), (10, 9, 10)):
            last = max(mu - 1, (3 * order - 10) // 2)
            d = [Fraction(source.randint(1, 20), source.randint(1, 9)) for _ in range(1 - mu, last + 1)]
            lam = [source.choice([Fraction(0), Fraction(1), Fraction(1, 2), Fraction(source.randint(1, 29), 30)])
                   for _ in range(3 - order, (3 * order - 10) // 2 + 1)]
            document = self.twoscale_json("stencil", f"nuli:n={order}", "--at",
                                          f"d={brackets(d)},lambda={brackets(lam)}")
            self.assertEqual(document["lowest"], 1 - mu)
            weights = [Fraction(c) for c in document["coefficients"]]
            x = [sum(d[:j]) for j in range(2 * mu)]
            middle = x[mu - 1] + d[mu - 1] / 2
            for e in range(rho + 1):
                self.assertEqual(sum(w * (y - middle) ** e for w, y in zip(weights, x)) == 0 ** e, e < rho, (order, e))

    def test_appendix(self):
        """Coefficients a_{i,j} of v_{4,3,i} in B-splines. The labels of lambda are one too large as printed; with them
        put right, -6, -5, -3, -2, -1, 1, 2 hold; -4 and 0 follow from their neighbours as below."""
        code = SPLINES + r"""
d=vector(19,k,(1+random(9))/(1+random(7))); l=vector(19,k,(1+random(8))/10); t=knots(-9,d,l);
u6(j)=if(j<-6||j>1,0,cf(t,4,4,3,0,j));
at(q)=bs(t,4,2*q-2,t(2*q),2*q);
a(j)=u6(j)+if(j%2,0,my(q=(j+2)/2);((q==0)-u(t,4,4,3,0,t(2*q),2*q))/at(q));
E(e)=d[e+10];
P(j)=l[j-1+10];
"""
        # printed entries, E(e) = d_{i+e}, P(j) = printed lambda_{i+j}
        printed = {
            -6: "-E(-3)*E(-2)*(-1+P(-2))^2*(E(-3)+E(-2)*P(-1))^2/(3*E(-1)*(E(-2)+E(-1))*(E(-3)+E(-2)+E(-1))"
                "*(E(-2)*(-2+P(-2))*P(-1)+E(-3)*(-1+P(-2))*(1+P(-1))))",
            -5: "-E(-2)^2*(E(-3)+E(-2)*P(-1))/(3*E(-1)*(E(-2)+E(-1))*(E(-3)+E(-2)+E(-1)))",
            -3: "(E(-1)*(E(0)+E(-1))*P(0)+E(-2)*(E(0)+E(-1)+E(0)*P(0)))/(3*E(0)*(E(-2)+E(-1)))",
            -1: "(E(0)*(E(0)+E(1)-E(0)*P(1))+E(-1)*(E(0)+2*E(1)-(E(0)+E(1))*P(1)))/(3*E(-1)*(E(0)+E(1)))",
            1: "E(1)^2*(-E(2)+E(1)*(-1+P(2)))/(3*E(0)*(E(0)+E(1))*(E(0)+E(1)+E(2)))",
            2: "-E(1)*E(2)*(E(2)-E(1)*(-1+P(2)))^2*P(3)^2/(3*E(0)*(E(0)+E(1))*(E(0)+E(1)+E(2))"
               "*(E(2)*(-2+P(2))*P(3)+E(1)*(-1+P(2))*(1+P(3))))",
        }
        for j, text in printed.items():
            code += f"print(a({j})=={text});\n"
        code += r"""
x2=E(-2);x1=E(-1);y0=E(0);y1=E(1);m=P(0);k=P(1);
den=3*y0*x1*(x2+x1)*(y0+y1)*(y0*(-2+m)*k+x1*(-1+m)*(1+k));
one=x2*(y0^3*(y0+y1)*(-2+m)*k^2-x1^3*(-1+m)^2*(2*y0+y1+(y0+y1)*k)+y0^2*x1*k*((y0+y1)*(-5+m+m^2)-(y1*(1+(-3+m)*m)+y0*(2+m*(-5+2*m)))*k)-y0*x1^2*(-1+m)*(-(y0+y1)*(2+m)+(y1*(-4+m)+3*y0*(-2+m))*k+(y0+y1)*m*k^2));
two=-x1*(-y0^3*(y0+y1)*(-3+m)*k^2+x1^3*(-1+m)^2*(2*y0+y1+(y0+y1)*k)+y0^2*x1*k*(-(y0+y1)*(-5+m+m^2)+(y1*(3+(-5+m)*m)+y0*(4+m*(-7+2*m)))*k)+y0*x1^2*(-1+m)*(-(y0+y1)*(2+m)+(y1*(-4+m)+3*y0*(-2+m))*k+(y0+y1)*(-1+2*m)*k^2));
print(a(-2)==(one+two)/den);
w(x,y,k,m)={my(A=k*x,B=m*y);[B^2*(A+y),A^2*(B+x),A*B*(x+y)+x*y*(A+B)];}
g=w(E(-2),E(-1),1-P(-1),P(0)); print(a(-4)==-(g[1]*a(-5)+g[2]*a(-3))/g[3]);
g=w(E(1),E(0),P(2),1-P(1)); print(a(0)==-(g[1]*a(1)+g[2]*a(-1))/g[3]);
"""
        self.assertEqual(pari(code).split(), ["1"] * 9)


class NulifsPolygon:
    """Closed polygons refined by the definition, in mpmath: every new point is the value of the spline interpolant of
    (2.4)-(2.7) of the points of this level, or of the cubic through four of them."""

    def __init__(self, points, edge_parameters, tags, kind):
        self.points, self.parameters, self.tags = points, edge_parameters, tags
        n = len(points)
        self.d = []
        for i in range(n):
            length = mp.sqrt(sum((a - b) ** 2 for a, b in zip(points[i], points[(i + 1) % n])))
            self.d.append({"uniform": mp.mpf(1), "chordal": length, "centripetal": mp.sqrt(length)}[kind])
        self.known = {}  # knots
        self.found = {}  # coefficients

    def knot(self, m):
        """t_m, x_0 = 0."""
        if m not in self.known:
            self.known[m] = self.compute_knot(m)
        return self.known[m]

    def compute_knot(self, m):
        n, edge = len(self.points), m // 2
        whole = sum(self.d) * (edge // n) + sum(self.d[:edge % n])
        return whole if m % 2 == 0 else whole + self.parameters[edge % n] * self.d[edge % n]

    def bspline(self, order, m, x, piece):
        if order == 1:
            return mp.mpf(1 if m == piece else 0)
        if m > piece or m + order - 1 < piece:
            return mp.mpf(0)
        t = self.knot
        left, right = t(m + order - 1) - t(m), t(m + order) - t(m + 1)
        value = mp.mpf(0)
        if left != 0:
            value += (x - t(m)) / left * self.bspline(order - 1, m, x, piece)
        if right != 0:
            value += (t(m + order) - x) / right * self.bspline(order - 1, m + 1, x, piece)
        return value

    def coefficient(self, *key):
        if key not in self.found:
            self.found[key] = self.compute_coefficient(*key)
        return self.found[key]

    def compute_coefficient(self, order, sigma, i, m):
        """(2.5): phi has the points as zeros that N_m sees, without x_i."""
        last = m // 2 + sigma
        seen = [self.knot(2 * q) for q in range(last - order + 1, last + 1) if q != i]
        if len(seen) == order:
            return mp.mpf(0)
        centre = self.knot(2 * i)
        phi, psi = [mp.mpf(1)], [mp.mpf(1)]  # from the constant term up, in y = x - centre
        for z in seen:
            phi = [(phi[k - 1] if k > 0 else 0) - (z - centre) * (phi[k] if k < len(phi) else 0)
                   for k in range(len(phi) + 1)]
        for q in range(1, order):
            z = self.knot(m + q) - centre
            psi = [(psi[k - 1] if k > 0 else 0) - z * (psi[k] if k < len(psi) else 0) for k in range(len(psi) + 1)]
        total = sum((-1) ** k * mp.factorial(k) * phi[k] * mp.factorial(order - 1 - k) * psi[order - 1 - k]
                    for k in range(order))
        return total / mp.factorial(order - 1) / phi[0]

    def weights(self, scheme, edge):
        t = self.knot
        x = (t(2 * edge) + t(2 * edge + 2)) / 2
        if scheme == "lagrange4":
            nodes = range(edge - 1, edge + 3)
            return {j: mp.fprod((x - t(2 * q)) / (t(2 * j) - t(2 * q)) for q in nodes if q != j) for j in nodes}
        order, mu = (3, 2) if scheme == "nuli4" else (4, 3)
        piece = 2 * edge + (0 if t(2 * edge + 1) >= x else 1)
        active = range(piece - order + 1, piece + 1)
        sigma = mu  # n = 3; for n = 4 it is mu - tau + 1 with tau = 1

        def u(i, at, inside):
            return sum(self.bspline(order, m, at, inside) * self.coefficient(order, sigma, i, m)
                       for m in range(inside - order + 1, inside + 1))

        result = {}
        for i in range(edge - mu + 1, edge + mu + 1):
            value = sum(self.bspline(order, m, x, piece) * self.coefficient(order, sigma, i, m) for m in active)
            if order == 4:
                # (2.6): l_q is N_{2q-2}, 1 at x_q.
                for q in range(edge - 2, edge + 4):
                    local = self.bspline(4, 2 * q - 2, x, piece)
                    if local != 0:
                        at = t(2 * q)
                        value += ((1 if q == i else 0) - u(i, at, 2 * q)) * local / self.bspline(4, 2 * q - 2, at, 2 * q)
            result[i] = value
        return result

    def refined(self, scheme):
        n = len(self.points)
        points, parameters, tags, d = [], [], [], []
        for e in range(n):
            w = self.weights(scheme, e)
            points += [self.points[e], [sum(w[j] * self.points[j % n][c] for j in w) for c in range(2)]]
            half = mp.mpf(1) / 2
            parameters += [self.parameters[e] if self.tags[v] else half for v in (e, (e + 1) % n)]
            tags += [self.tags[e], False]
            d += [self.d[e] / 2] * 2
        self.points, self.parameters, self.tags, self.d = points, parameters, tags, d
        self.known, self.found = {}, {}


class ClosedPolygons(ProgramTest):
    def test_nine_runs(self):
        """Three rules, three parametrisations: 28 of 30 digits."""
        rows = [("0", "0", "0.5", 0), ("6", "-0.4", "0.9", 1), ("6.35", "0", "0.125", 1), ("6.5", "3", "0.5", 0),
                ("4.3", "3.3", "0.75", 1), ("4.2", "6.2", "0.5", 0), ("0.3", "6.1", "0.4", 0)]
        with tempfile.TemporaryDirectory() as folder, mp.workdps(45):
            path = os.path.join(folder, "p.csv")
            with open(path, "w", encoding="utf-8") as f:
                f.write("x,y,lambda,tag\n" + "".join(f"{x},{y},{l},{t}\n" for x, y, l, t in rows))
            for scheme in ("nuli4", "nuli6", "lagrange4"):
                for kind in ("centripetal", "chordal", "uniform"):
                    with self.subTest(scheme=scheme, kind=kind):
                        p = NulifsPolygon([[mp.mpf(x), mp.mpf(y)] for x, y, _, _ in rows],
                                          [mp.mpf(l) for _, _, l, _ in rows], [t == 1 for *_, t in rows], kind)
                        for _ in range(2):
                            p.refined(scheme)
                        ours = self.twoscale("refine", scheme, "--levels", "2", "--parametrization", kind,
                                             "--digits", "30", path).split()[1:]
                        doubles = self.twoscale("refine", scheme, "--levels", "2", "--parametrization", kind,
                                                path).split()[1:]
                        self.assertEqual(len(ours), 4 * len(rows))
                        for row, rough, point in zip(ours, doubles, p.points):
                            for text, double, number in zip(row.split(",")[:2], rough.split(",")[:2], point):
                                self.assertLess(abs(mp.mpf(text) - number), mp.mpf(10) ** -28)
                                self.assertLess(abs(mp.mpf(double) - number), 1e-13)


class Junctions(ProgramTest):
    def test_characteristic_polynomials(self):
        for scheme, at in (("nuli4", "alpha=2,lambda=[1/3,1/2]"), ("nuli4", "alpha=5/3,lambda=[1,1/5]"),
                           ("nuli6", "alpha=3/4,lambda=[2/3,1/4]"), ("lagrange4", "alpha=4"),
                           ("nuli:n=6", "alpha=2,lambda=[1/3,1]")):
            d = self.twoscale_json("spectrum", scheme, "--at", at)
            rows = "[" + ";".join(",".join(row) for row in d["matrix"]) + "]"
            factors = "*".join(f"({to_pari(f)})^{m}" for f, m in d["characteristic_polynomial"]["factors"])
            self.assertEqual(pari(f"print(charpoly({rows}, 'x) == {factors})"), "1")


if __name__ == "__main__":
    unittest.main()
