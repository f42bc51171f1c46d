(()=>{function N(i,t={},...e){let n=document.createElement(i);return ed(n,t,e),n}function bo(i,t={},...e){let n=document.createElementNS("http://www.w3.org/2000/svg",i);return ed(n,t,e),n}function ed(i,t,e){for(let[n,s]of Object.entries(t))s==null||s===!1||(n.startsWith("on")?i.addEventListener(n.slice(2),s):i.setAttribute(n,s===!0?"":s));for(let n of e.flat())n==null||n===!1||i.append(n instanceof Node?n:document.createTextNode(String(n)))}function nd(i){return i.split(/(?<=[_/\\,=+]|\.(?=[a-z_]))(?=.)/i).flatMap((t,e)=>e?[N("wbr"),t]:[t])}function Xe(i,...t){return N("section",{class:"card"},i?N("h2",{},i):null,...t)}function dn(i){return getComputedStyle(document.documentElement).getPropertyValue("--"+i).trim()}var da=[];function ds(i){da.push(i)}function bc(i){document.documentElement.dataset.theme=i?"dark":"light";for(let t of da)t()}function pa(){let i=document.documentElement.dataset.theme;return i?i==="dark":matchMedia("(prefers-color-scheme: dark)").matches}var Mo;addEventListener("beforeprint",()=>{Mo??(Mo=document.documentElement.dataset.theme??""),bc(!1)});addEventListener("afterprint",()=>{if(Mo!==void 0){document.documentElement.dataset.theme=Mo,Mo||delete document.documentElement.dataset.theme,Mo=void 0;for(let i of da)i()}});matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{if(!document.documentElement.dataset.theme)for(let i of da)i()});var ma="\u2212",sd="\xD7",Sc="\u202F",id="\xB5",N0={m:[[1,"m"],[.001,"mm"],[1e-6,id+"m"]],kg:[[1,"kg"],[.001,"g"],[1e-6,"mg"]],s:[[1,"s"],[.001,"ms"],[1e-6,id+"s"]],Pa:[[1e9,"GPa"],[1e6,"MPa"],[1e3,"kPa"],[1,"Pa"]],N:[[1e3,"kN"],[1,"N"],[.001,"mN"]],"N m":[[1e3,"kN m"],[1,"N m"],[.001,"mN m"]],J:[[1e3,"kJ"],[1,"J"],[.001,"mJ"]],Hz:[[1e3,"kHz"],[1,"Hz"]]},O0={m:1,kg:1,s:.1};function Fi(i,t){let e=N0[t];if(!e||!(i>0))return{factor:1,unit:t||""};for(let[r,o]of e)if(i>=r*(r===1?O0[t]??1:1)*.999)return{factor:r,unit:o};let[n,s]=e[e.length-1];return{factor:n,unit:s}}function ze(i,t=4){if(i==null||Number.isNaN(i))return"\u2013";if(!Number.isFinite(i))return i>0?"\u221E":ma+"\u221E";if(i===0)return"0";let e=Math.abs(i),n;if(e>=1e6||e<1e-4){let[s,r]=i.toExponential(t-1).split("e");n=Number(s)+sd+"10"+rd(Number(r))}else{let s=Math.max(0,t-1-Math.floor(Math.log10(e)));n=Number.isInteger(i)&&e<1e6?String(i):i.toFixed(Math.min(s,8))}return n.replace(/-/g,ma)}function Fn(i,t=4){return ze(i,t).replace(/(\.\d*?)0+(?!\d)/,"$1").replace(/\.(?!\d)/,"")}function rd(i){let t="\u2070\xB9\xB2\xB3\u2074\u2075\u2076\u2077\u2078\u2079";return(i<0?"\u207B":"")+[...String(Math.abs(i))].map(n=>t[Number(n)]).join("")}function Os(i){return i.replace(/\+-/g,"\xB1").replace(/(\d)e([+-]\d+)\b/g,(t,e,n)=>e+sd+"10"+rd(Number(n))).replace(/(^|[\s(])-(?=\d)/g,`$1${ma}`)}var od=i=>!i||i==="-"||i.includes(" or ")?"":i;function zt(i,t,e=4){if(i==null||Number.isNaN(i))return"\u2013";let{factor:n,unit:s}=Fi(Math.abs(i),t==="-"?"":t);return ze(i/n,e)+(s?"\xA0"+s:"")}function ga(i,t,e=4){let{factor:n,unit:s}=Fi(Math.max(0,...i.map(Math.abs)),t);return r=>ze(r/n,e)+(s?"\xA0"+s:"")}function ad(i,t,e=4){if(i.length===1)return zt(i[0],t,e);let{factor:n,unit:s}=Fi(Math.max(...i.map(Math.abs)),t==="-"?"":t);return`(${i.map(r=>Fn(r/n,e)).join(", ")})${s?"\xA0"+s:""}`}function So(i,t){return!t||i===null||i===void 0?Rn(i):(i>0?"+":"")+ze(i,4)}var ld=i=>Object.values(i.constraints??{}).sort((t,e)=>e.violation-t.violation)[0],yr=i=>i?.response==="own function",wc=i=>ze(100*i,2)+Sc+"%";function Rn(i){if(i==null||Number.isNaN(i))return"\u2013";let t=100*i,e=Math.abs(t);if(e<5e-4)return"0"+Sc+"%";let n=e>=100?0:e>=10?1:e>=1?2:3;return(t>0?"+":ma)+e.toFixed(n)+Sc+"%"}var wo=i=>Rn(i).replace("+","");function cd(i){if(i.command!=="lean")return[];let t=i.time_given_s/i.time_s;return[si(`error of '${i.response}'`,wo(i.error),`${wo(i.tolerance)} allowed`,i.error>i.tolerance?"bad":"fine"),si("time",`${zt(i.time_given_s,"s",3)} \u2192 ${zt(i.time_s,"s",3)}`,t>1?`${ze(t,2)} times as fast`:"not faster than given")]}function hd(i){if(i.command!=="lean"||!i.lean)return[];let e=[["lean",i.lean,i.error,i.time_s],["as given",i.given,i.error_given,i.time_given_s],["reference",i.reference,i.reference_error,i.time_reference_s],["held out",i.held_out,null,i.time_held_out_s]].filter(([,r])=>r).map(([r,o,a,l])=>[r,o.space,o.steps,zt(o.step,"s",3),o.tangent,Object.entries(o.beams??{}).map(([c,h])=>`${c} ${F0(h)}`).join(", ")||"\u2013",wo(a),zt(l,"s",3)]),n=Xe("Lean model",ri(["model","space","steps","step","tangent","beams","error","time"],e,["","","n","n","","wrap","n","n"]),N("p",{class:"note"},`Errors are of the largest '${i.response}', against the reference; that of the lean model in the end against the run held out, that decided nothing. ${i.runs} runs.`),i.changes?.length?N("h3",{},"Changes of the scene"):null,i.changes?.length?N("ul",{class:"changes"},i.changes.map(r=>N("li",{},r))):null),s=i.decisions?.length?Xe("Decisions",ri(["about","choice","figure","limit","evidence"],i.decisions.map(r=>[r.about,Os(r.choice),wo(r.figure),wo(r.limit),Os(r.evidence??"")]),["","wrap","n","n","wrap"])):null;return s?.classList.add("long"),[n,s]}function F0(i){return i.rigid?"rigid":i.modes!==null&&i.modes!==void 0?`${i.modes} modes of ${i.elements}`:`${i.elements}${i.segments?" segments":""}${i.order===4?" of order 4":""}`}var ud=["done","optimal","converged"],k0=["converged","recovered","running","incomplete","cycle limit","interrupted"];function Ac(i,t=!1){let n=ud.includes(i)&&!(t&&i==="converged")?"good":k0.includes(i)?"fair":"poor";return N("span",{class:`badge ${n}`},i)}var fd=i=>ud.includes(i),_a=({motion:i,summary:t})=>t.load_cases||i&&i.abscissa!=="time"?"study":"motion",B0={optimal:"The optimality conditions of the motion hold, and all limits are met.",converged:"Loads and design agree; whether the design is optimal for the motion, the residual below tells.","cycle limit":"As many cycles as allowed, without agreement; the best design so far is shown.",oscillating:"The designs went to and fro; the best one is shown.",infeasible:"Limits are exceeded, and no step from this design improves that; another start may.",inaccurate:"The end was reached, but the time integration lost or made too much energy."};function z0(i){if(!i)return i;let t=Os(i),n=/^\w+[._]\w/.test(t)?t:t[0].toUpperCase()+t.slice(1);return/[.!?]$/.test(n)?n:`${n}.`}function si(i,t,e,n){return N("div",{class:"tile"},N("span",{},i),N("b",{class:n??""},t),e?N("small",{},e):null)}var Ec=i=>i?i.total??(i.mesh??0)+(i.step??0):void 0,xa=({error:i})=>Ec(i),ya=i=>`\xB1\xA0${i}`;function V0(i){let{kkt_residual:t,worst_constraint:e}=i.summary;return t===null?"not checked":e>.001?"but limits are exceeded":`${t<=.01?"optimal":"not optimal"} for the ${_a(i)}`}function Tc({summary:i,folder:t,batch:e}){return(i.name||t)+(e?`: case ${t}`:"")}function dd(i){let t=i.summary,e=t.reason,n=/optimality conditions of the/.test(e)?null:B0[t.status],s=cd(t);if(t.mass_initial!==void 0&&s.push(si("mass",`${zt(t.mass_initial,"kg")} \u2192 ${zt(t.mass_final,"kg")}`,Rn(t.mass_final/t.mass_initial-1))),t.objective&&t.objective.quantity!=="mass"&&s.push(si(t.objective.quantity,`${zt(t.objective.initial,t.objective.unit)} \u2192 ${zt(t.objective.final,t.objective.unit)}`,Rn(t.objective.final/t.objective.initial-1))),t.worst_constraint!==void 0&&t.worst_constraint!==null){let r=t.worst_constraint_error===void 0?"":`, ${ya(wc(t.worst_constraint_error))} by mesh and step`;s.push(si("worst limit",So(t.worst_constraint,yr(ld(t))),(t.worst_constraint>.001?"above it":"it is met")+r,t.worst_constraint>.001?"bad":"fine"))}return t.cycles&&s.push(si("cycles",t.cycles,`in ${zt(t.wall_s,"s",3)}`)),t.kkt_residual!==void 0&&s.push(si("KKT residual",t.kkt_residual===null?"\u2013":ze(t.kkt_residual,2),V0(i))),t.frequencies_hz?.length?s.push(si("lowest frequency",zt(t.frequencies_hz[0],"Hz",4),`of ${t.frequencies_hz.length}`)):t.steps&&t.cycles===void 0&&s.push(si("steps",t.steps,`in ${zt(t.stepping_s,"s",3)}`)),t.cases&&s.push(si("cases",`${t.done} of ${t.cases}`,t.failed?`${t.failed} failed`:"none failed")),t.rows&&s.push(si("rows",`${t.done} of ${t.rows}`,t.response?`response '${t.response}'`:"")),N("header",{},i.batch?N("nav",{},N("a",{href:"../../report.html"},`\u2190 ${i.batch}`)):null,N("div",{class:"title"},N("h1",{},Tc(i)),Ac(t.status,"kkt_residual"in t)),N("p",{class:"reason"},z0(e?.replace("conditions of the motion",`conditions of the ${_a(i)}`)),n?N("span",{}," "+n.replace("motion",_a(i))):null),t.warnings?.length?N("ul",{class:"warnings"},t.warnings.map(r=>N("li",{},Os(r)))):null,s.length?N("div",{class:"tiles"},s):null)}function ri(i,t,e=[]){let n=i.map((o,a)=>a===0||t.some(l=>l[a]!=="\u2013")),s=(o,a)=>typeof o=="string"&&e[a]!=="n"?nd(o):o,r=(o,a,l)=>n[l]&&N(o,{class:e[l]??""},s(a,l));return N("div",{class:"scroll"},N("table",{},N("thead",{},N("tr",{},i.map((o,a)=>r("th",o,a)))),N("tbody",{},t.map(o=>N("tr",{},o.map((a,l)=>r("td",a,l)))))))}function H0(i){let{abscissa:t="time",unit:e="s"}=i.motion??{abscissa:i.charts[0]?.abscissa,unit:i.charts[0]?.abscissa_unit};return{name:t.replace("_"," "),unit:e}}var G0=12;function pd(i){let t=i.summary,e=H0(i),n=Object.entries(t.constraints??{});if(n.length===0)return null;n.length>G0&&n.sort(([,l],[,c])=>c.violation-l.violation);let s=t.objective?.unit??"kg",r=Object.entries(t.prices??{}),o=l=>r.filter(([c])=>c===l||c.startsWith(`${l} at `)).reduce((c,[,h])=>c+h,0),a=n.map(([l,c])=>[l,zt(c.limit,c.unit),zt(c.max_abs_initial,c.unit),zt(c.max_abs_final,c.unit),N("span",{class:c.violation>.001?"bad":"fine"},So(c.violation,yr(c))),xa(c)===void 0?"\u2013":ya(wc(xa(c)/c.limit)),c.at_time?zt(c.at_time,e.unit,3):"\u2013",o(l)?zt(o(l)/100,s,3):"\u2013"]);for(let[l,c]of r)n.some(([h])=>l===h||l.startsWith(`${h} at `))||a.push([l,"\u2013","\u2013","\u2013","\u2013","\u2013","\u2013",zt(c/100,s,3)]);return Xe("Limits",ri(["limit","allowed","before","after","above it","error",e.unit==="s"?"at":`at ${e.name}`,"1 % more saves"],a,["","n","n","n","n","n","n","n"]),t.kkt?N("p",{class:"note"},`Optimality conditions of the ${_a(i)}: ${Os(t.kkt)}.`):null)}function W0(i){let t=s=>Math.max(0,Math.min(1,(s-i.lower)/(i.upper-i.lower||1))),e=N("i",{class:"start"}),n=N("i",{class:"end"});return e.style.left=`${100*t(i.initial)}%`,n.style.left=`${100*t(i.final)}%`,N("span",{class:"bounds",title:`${zt(i.lower,i.unit)} \u2026 ${zt(i.upper,i.unit)}`},e,n)}function md(i){let t=Object.keys(i.design??{});if(t.length===0)return null;let e=t.map(n=>{let s={...i.design_range[n],final:i.design[n]},r=s.initial?Rn(s.final/s.initial-1):"";return[n,zt(s.initial,s.unit),zt(s.final,s.unit),r,W0(s)]});return Xe("Design",ri(["variable","start","end","change","between its bounds"],e,["","n","n","n",""]))}function gd(i,t){let e=Object.entries(i.responses??{});if(e.length===0)return null;let n=e.map(([r,o])=>[r,zt(o.max_abs,o.unit),xa(o)===void 0?"\u2013":ya(zt(xa(o),o.unit,2)),Fn(o.at_time,4),ad([o.final].flat().map(a=>a!==null&&Math.abs(a)<1e-9*o.max_abs?0:a),o.unit),Ec(o.error?.end)===void 0?"\u2013":ya(zt(Ec(o.error.end),o.unit,2))]),s=t?.abscissa_unit&&t.abscissa_unit!=="-"?`at [${t.abscissa_unit}]`:"at";return Xe("Responses",ri(["response","largest","error",s,"at the end","error"],n,["","n","n","n","n","n"]))}function _d(i){let t=[];for(let[e,n]of Object.entries(i.gradients??{}))for(let[s,r]of Object.entries(n))for(let[o,a]of Object.entries(r.by)){let l=i.parameters[o];t.push([`${e}, ${s}`,zt(r.value,r.unit),o,`${ze(a,4)} ${q0(r.unit,l.unit)}`,r.value&&a!==null?Rn(.01*a*l.value/r.value):"\u2013"])}return t.length?Xe("Derivatives",ri(["figure","value","parameter","derivative","1 % more changes it by"],t,["","n","wrap","n","n"])):null}var X0={"^2":"\xB2","^3":"\xB3"},q0=(i,t)=>(t?.includes(" or ")?`${i} per SI unit`:Y0(i,t)).replace(/\^[23]/g,e=>X0[e]),Y0=(i,t)=>t&&t!=="-"?`${i&&i!=="-"?i:"1"}/${t.includes("/")?`(${t})`:t}`:i==="-"?"":i;function xd(i){if(!i.references?.length)return null;let t=i.references.map(n=>[n.changes.join(", ")||"as the scene",n.formalisms.join(", "),zt(n.size,i.unit),zt(n.floor,i.unit,2),ze(n.floor/n.size,2)]),e=(i.ratios??[]).map(n=>[n.formalism,n.to,n.pairs,n.error===null?"\u2013":"\xD7 "+ze(n.error,3),n.time===null?"\u2013":"\xD7 "+ze(n.time,3)]);return Xe("References and ratios",ri(["motion","references","size","difference","relative"],t,["","","n","n","n"]),e.length?ri(["formalism","against","pairs","error","time"],e,["","","n","n","n"]):null)}function $0(i,t){let e=ri(["mode","frequency [Hz]"],i.frequencies_hz.map((s,r)=>[r+1,ze(s,5)]),["","n"]);if(t?.t.length!==i.frequencies_hz.length)return e;let n=[...e.querySelectorAll("tbody tr")];for(let[s,r]of n.entries()){let o=()=>t.set(t.t[s]);r.className="opens",r.tabIndex=0,r.addEventListener("click",o),r.addEventListener("keydown",a=>a.key==="Enter"&&o())}return t.listen(()=>n.forEach((s,r)=>s.setAttribute("aria-current",r===Math.round(t.record())))),e}function yd(i,t){let e=[];i.frequencies_hz?.length&&e.push($0(i,t)),i.critical_loads?.length&&e.push(ri(["critical load","kind"],i.critical_loads.map(r=>[ze(r.load,5),r.limit_point?"limit point":"bifurcation"]),["",""]));let n=Object.entries(i.parts??{});n.length&&e.push(ri(["part","cells","modes","mass","accurate up to"],n.map(([r,o])=>[r,o.cells,o.modes,zt(o.mass,"kg"),zt(o.right_up_to_hz,"Hz",3)]),["","n","n","n","n"]));let s=[i.frequencies_hz?.length&&"modes",i.critical_loads?.length&&"critical loads",n.length&&"meshed parts"].filter(Boolean).join(", ");return e.length?Xe(s[0].toUpperCase()+s.slice(1),...e):null}function Z0(i){if(i.command!=="map")return"";let t=Object.entries(i.over);return` --over '${t.map(([n,s])=>`${n}=${Number(s.from.toPrecision(8))}:${Number(s.to.toPrecision(8))}`).join(",")}' --points ${t.map(([,n])=>n.points).join(",")}`}var K0=i=>/^[\w@%+=:,./-]+$/.test(i)?i:`'${i.replace(/'/g,"'\\''")}'`;function vd(i){let t=i.summary,e=N("dl",{}),n=(s,r)=>r&&e.append(N("dt",{},s),N("dd",{},r));return n("command",t.arguments?.length?`liesl ${t.arguments.map(K0).join(" ")}`:`liesl ${t.command}${t.input?" "+t.input:""}${Z0(t)}${(t.overrides??[]).map(s=>` --set '${s}'`).join("")}`),n("overrides",t.overrides?.join("\u2003")),n("folder",i.folder),n("input (SHA-256)",t.input_sha256),t.space&&n("computed",`${t.space}: ${t.space_reason}`),t.wall_s&&n("time",`${zt(t.wall_s,"s",3)}${t.cpu_s?`, processors ${zt(t.cpu_s,"s",3)}`:""}`),t.newton_iterations&&n("corrections",`${t.newton_iterations} in ${t.steps} step${t.steps===1?"":"s"}`),t.peak_memory_mb&&n("memory",`${ze(t.peak_memory_mb,3)} MB`),n("versions",Object.entries(t.versions??{}).map(([s,r])=>`${s} ${r}`).join(" \xB7 ")),Xe("Where it comes from",e)}var j0={mass_initial:"mass before",mass_final:"mass after",worst_constraint:"worst limit, above it",worst_constraint_error:"error of the worst limit",kkt_residual:"KKT residual",kkt:"KKT residual",load_change:"change of the loads",newton_iterations:"corrections",rejected_steps:"halved steps",stepping_s:"time of the steps",wall_s:"time",cpu_s:"processor time",cpu_spread:"spread of the time",peak_memory_mb:"memory",tangent_refreshes:"tangents anew",energy_drift:"drift of energy",momentum_drift:"drift of momentum",angular_momentum_drift:"drift of angular momentum",constraint_residual:"residual of the joints",violation:"worst limit, above it"},Q0=[[/^(.+)\.max_abs$/,"$1, largest"],[/^(.+)\.violation$/,"$1, above its limit"],[/^(.+)\.final\.([xyz])$/,"$1.$2 at the end"],[/^(.+)\.final$/,"$1 at the end"]];function Md(i){for(let[t,e]of Q0)if(t.test(i))return i.replace(t,e);return j0[i]??i.replace(/_/g," ")}var t_=/^(worst_constraint(_error)?|violation|load_change|.+\.violation)$/;function bd(i){if(i.number&&t_.test(i.name))return{title:Md(i.name),factor:.01,shown:"%"};let t=i.number?i.cells.filter(s=>s!==null).map(Math.abs):[],{factor:e,unit:n}=Fi(t.length?Math.max(...t):0,i.number?i.unit:"");return{title:Md(i.name),factor:e,shown:n}}var e_=[[.278,.085,.41],[.283,.161,.468],[.254,.265,.53],[.207,.372,.553],[.164,.471,.558],[.128,.567,.551],[.135,.659,.518],[.267,.749,.441],[.478,.821,.318],[.741,.873,.15],[.993,.906,.144]],n_=[[.1,.32,.75],[.36,.58,.9],[.72,.8,.92],[.8,.8,.8],[.95,.72,.62],[.88,.42,.3],[.7,.09,.15]];function Sd(i){let t=new Float32Array(768);for(let e=0;e<256;++e){let n=e/255*(i.length-1),s=Math.min(Math.floor(n),i.length-2);for(let r=0;r<3;++r)t[3*e+r]=i[s][r]+(n-s)*(i[s+1][r]-i[s][r])}return t}var wd={size:Sd(e_),signed:Sd(n_)};function vr(i,t,e,n){let s=wd[i],r=3*Math.max(0,Math.min(255,Math.round(255*t)));e[n]=s[r],e[n+1]=s[r+1],e[n+2]=s[r+2]}function va(i,t){let e=wd[i],n=3*Math.max(0,Math.min(255,Math.round(255*t)));return`rgb(${[0,1,2].map(s=>Math.round(255*e[n+s])).join(" ")})`}var Pn=["#2f7fd8","#e08a1e","#2a9d63","#c8453b","#8b62c9","#8a6d3b","#d65fa0","#6c7a89"];var en="u-",i_="uplot",s_=en+"hz",r_=en+"vt",o_=en+"title",a_=en+"wrap",l_=en+"under",c_=en+"over",h_=en+"axis",Bs=en+"off",u_=en+"select",f_=en+"cursor-x",d_=en+"cursor-y",p_=en+"cursor-pt",m_=en+"legend",g_=en+"live",__=en+"inline",x_=en+"series",y_=en+"marker",Ed=en+"label",v_=en+"value",To="width",Co="height",Eo="top",Ad="bottom",Mr="left",Cc="right",Xc="#000",Td=Xc+"0",Rc="mousemove",Cd="mousedown",Pc="mouseup",Rd="mouseenter",Pd="mouseleave",Id="dblclick",M_="resize",b_="scroll",Ld="change",Ea="dppxchange",qc="--",Cr=typeof window<"u",Nc=Cr?document:null,Sr=Cr?window:null,S_=Cr?navigator:null,ye,Ma;function Oc(){let i=devicePixelRatio;ye!=i&&(ye=i,Ma&&kc(Ld,Ma,Oc),Ma=matchMedia(`(min-resolution: ${ye-.001}dppx) and (max-resolution: ${ye+.001}dppx)`),zs(Ld,Ma,Oc),Sr.dispatchEvent(new CustomEvent(Ea)))}function Xn(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Fc(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Oe(i,t,e){i.style[t]=e+"px"}function mi(i,t,e,n){let s=Nc.createElement(i);return t!=null&&Xn(s,t),e?.insertBefore(s,n),s}function oi(i,t){return mi("div",i,t)}var Dd=new WeakMap;function ki(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Dd.get(i);r!=o&&(i.style.transform=r,Dd.set(i,r),t<0||e<0||t>n||e>s?Xn(i,Bs):Fc(i,Bs))}var Ud=new WeakMap;function Nd(i,t,e){let n=t+e,s=Ud.get(i);n!=s&&(Ud.set(i,n),i.style.background=t,i.style.borderColor=e)}var Od=new WeakMap;function Fd(i,t,e,n){let s=t+""+e,r=Od.get(i);s!=r&&(Od.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Yc={passive:!0},w_={...Yc,capture:!0};function zs(i,t,e,n){t.addEventListener(i,e,n?w_:Yc)}function kc(i,t,e,n){t.removeEventListener(i,e,Yc)}Cr&&Oc();function gi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:qn((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function up(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var fp=i=>i!=null,dp=i=>i!=null&&i>0,Ca=up(fp),E_=up(dp);function A_(i,t,e,n=0,s=!1){let r=s?E_:Ca,o=s?dp:fp;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ce,l??-Ce]}function Ra(i,t,e,n){let s=zd(i),r=zd(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?$i:pp,a=s==1?qn:ai,l=r==1?ai:qn,c=a(o(tn(i))),h=l(o(tn(t))),u=wr(e,c),f=wr(e,h);return e==10&&(c<0&&(u=Re(u,-c)),h<0&&(f=Re(f,-h))),n||e==2?(i=u*s,t=f*r):(i=xp(i,u),t=Pa(t,f)),[i,t]}function $c(i,t,e,n){let s=Ra(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Zc=.1,kd={mode:3,pad:Zc},Po={pad:0,soft:null,mode:0},T_={min:Po,max:Po};function Aa(i,t,e,n){return Ia(e)?Bd(i,t,e):(Po.pad=e,Po.soft=n?0:null,Po.mode=n?3:0,Bd(i,t,T_))}function ge(i,t){return i??t}function C_(i,t,e){for(t=ge(t,0),e=ge(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Bd(i,t,e){let n=e.min,s=e.max,r=ge(n.pad,0),o=ge(s.pad,0),a=ge(n.hard,-Ce),l=ge(s.hard,Ce),c=ge(n.soft,Ce),h=ge(s.soft,-Ce),u=ge(n.mode,0),f=ge(s.mode,0),p=t-i,g=$i(p),x=In(tn(i),tn(t)),m=$i(x),d=tn(m-g);(p<1e-24||d>10)&&(p=0,(i==0||t==0)&&(p=1e-24,u==2&&c!=Ce&&(r=0),f==2&&h!=-Ce&&(o=0)));let M=p||x||1e3,b=$i(M),y=wr(10,qn(b)),U=M*(p==0?i==0?.1:1:r),C=Re(xp(i-U,y/10),24),D=i>=c&&(u==1||u==3&&C<=c||u==2&&C>=c)?c:Ce,O=In(a,C<D&&i>=D?D:_i(D,C)),A=M*(p==0?t==0?.1:1:o),S=Re(Pa(t+A,y/10),24),R=t<=h&&(f==1||f==3&&S>=h||f==2&&S<=h)?h:-Ce,G=_i(l,S>R&&t<=R?R:In(R,S));return O==G&&O==0&&(G=100),[O,G]}var R_=new Intl.NumberFormat(Cr?S_.language:"en-US"),Kc=i=>R_.format(i),Yn=Math,wa=Yn.PI,tn=Yn.abs,qn=Yn.floor,Qe=Yn.round,ai=Yn.ceil,_i=Yn.min,In=Yn.max,wr=Yn.pow,zd=Yn.sign,$i=Yn.log10,pp=Yn.log2,P_=(i,t=1)=>Yn.sinh(i)*t,Ic=(i,t=1)=>Yn.asinh(i/t),Ce=1/0;function Vd(i){return($i((i^i>>31)-(i>>31))|0)+1}function Bc(i,t,e){return _i(In(i,t),e)}function mp(i){return typeof i=="function"}function ae(i){return mp(i)?i:()=>i}var I_=()=>{},gp=i=>i,_p=(i,t)=>t,L_=i=>null,Hd=i=>!0,Gd=(i,t)=>i==t,D_=/\.\d*?(?=9{6,}|0{6,})/gm,Vs=i=>{if(vp(i)||ms.has(i))return i;let t=`${i}`,e=t.match(D_);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Vs(s)}e${r}`}return Re(i,n)};function Fs(i,t){return Vs(Re(Vs(i/t))*t)}function Pa(i,t){return Vs(ai(Vs(i/t))*t)}function xp(i,t){return Vs(qn(Vs(i/t))*t)}function Re(i,t=0){if(vp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Qe(n)/e}var ms=new Map;function yp(i){return((""+i).split(".")[1]||"").length}function Lo(i,t,e,n){let s=[],r=n.map(yp);for(let o=t;o<e;o++){let a=tn(o),l=Re(wr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?h:Re(h,u);s.push(f),ms.set(f,u)}}return s}var Io={},Jc=[],Er=[null,null],ps=Array.isArray,vp=Number.isInteger,U_=i=>i===void 0;function Wd(i){return typeof i=="string"}function Ia(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function N_(i){return i!=null&&typeof i=="object"}var O_=Object.getPrototypeOf(Uint8Array),Mp="__proto__";function Ar(i,t=Ia){let e;if(ps(i)){let n=i.find(s=>s!=null);if(ps(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Ar(i[s],t)}else e=i.slice()}else if(i instanceof O_)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Mp&&(e[n]=Ar(i[n],t))}else e=i;return e}function $e(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Mp&&(Ia(i[s])?$e(i[s],Ar(n[s])):i[s]=Ar(n[s]))}return i}var F_=0,k_=1,B_=2;function z_(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function V_(i,t){if(W_(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return X_(o[0])||(o=G_(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=t?t[o][c]:k_,p=[];for(let g=0;g<h.length;g++){let x=h[g],m=r.get(l[g]);x===null?f!=F_&&(u[m]=x,f==B_&&p.push(m)):u[m]=x}z_(u,p,s),n.push(u)}}return n}var H_=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function G_(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function W_(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function X_(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=In(1,qn((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var bp=["January","February","March","April","May","June","July","August","September","October","November","December"],Sp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function wp(i){return i.slice(0,3)}var q_=Sp.map(wp),Y_=bp.map(wp),$_={MMMM:bp,MMM:Y_,WWWW:Sp,WWW:q_};function Ao(i){return(i<10?"0":"")+i}function Z_(i){return(i<10?"00":i<100?"0":"")+i}var K_={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Ao(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Ao(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Ao(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Ao(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Ao(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Z_(i.getMilliseconds())};function jc(i,t){t=t||$_;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?K_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var J_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function j_(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==J_?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var Ep=i=>i%1==0,Ta=[1,2,2.5,5],Q_=Lo(10,-32,0,Ta),Ap=Lo(10,0,32,Ta),tx=Ap.filter(Ep),ks=Q_.concat(Ap),Qc=`
`,Tp="{YYYY}",Xd=Qc+Tp,Cp="{M}/{D}",Ro=Qc+Cp,ba=Ro+"/{YY}",Rp="{aa}",ex="{h}:{mm}",br=ex+Rp,qd=Qc+br,Yd=":{ss}",Me=null;function Pp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Lo(10,0,3,Ta).filter(Ep):Lo(10,-3,0,Ta)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Tp,Me,Me,Me,Me,Me,Me,1],[s*28,"{MMM}",Xd,Me,Me,Me,Me,Me,1],[s,Cp,Xd,Me,Me,Me,Me,Me,1],[n,"{h}"+Rp,ba,Me,Ro,Me,Me,Me,1],[e,br,ba,Me,Ro,Me,Me,Me,1],[t,Yd,ba+" "+br,Me,Ro+" "+br,Me,qd,Me,1],[i,Yd+".{fff}",ba+" "+br,Me,Ro+" "+br,Me,qd,Me,1]];function h(u){return(f,p,g,x,m,d)=>{let M=[],b=m>=o,y=m>=r&&m<o,U=u(g),C=Re(U*i,3),D=Lc(U.getFullYear(),b?0:U.getMonth(),y||b?1:U.getDate()),O=Re(D*i,3);if(y||b){let A=y?m/r:0,S=b?m/o:0,R=C==O?C:Re(Lc(D.getFullYear()+S,D.getMonth()+A,1)*i,3),G=new Date(Qe(R/i)),F=G.getFullYear(),W=G.getMonth();for(let J=0;R<=x;J++){let K=Lc(F+S*J,W+A*J,1),Q=K-u(Re(K*i,3));R=Re((+K+Q)*i,3),R<=x&&M.push(R)}}else{let A=m>=s?s:m,S=qn(g)-qn(C),R=O+S+Pa(C-O,A);M.push(R);let G=u(R),F=G.getHours()+G.getMinutes()/e+G.getSeconds()/n,W=m/n,J=f.axes[p]._space,K=d/J;for(;R=Re(R+m,i==1?0:3),!(R>x);)if(W>1){let Q=qn(Re(F+W,6))%24,ct=u(R).getHours()-Q;ct>1&&(ct=-1),R-=ct*n,F=(F+W)%24;let mt=M[M.length-1];Re((R-mt)/m,3)*K>=.7&&M.push(R)}else M.push(R)}return M}}return[l,c,h]}var[nx,ix,sx]=Pp(1),[rx,ox,ax]=Pp(.001);Lo(2,-53,53,[1]);function $d(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Zd(i,t){return(e,n,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,h,u,f,p;return n.map(g=>{let x=i(g),m=x.getFullYear(),d=x.getMonth(),M=x.getDate(),b=x.getHours(),y=x.getMinutes(),U=x.getSeconds(),C=m!=l&&a[2]||d!=c&&a[3]||M!=h&&a[4]||b!=u&&a[5]||y!=f&&a[6]||U!=p&&a[7]||a[1];return l=m,c=d,h=M,u=b,f=y,p=U,C(x)})}}function lx(i,t){let e=jc(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Lc(i,t,e){return new Date(i,t,e)}function Kd(i,t){return t(i)}var cx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Jd(i,t){return(e,n,s,r)=>r==null?qc:t(i(n))}function hx(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function ux(i,t){return i.series[t].fill(i,t)}var fx={show:!0,live:!0,isolate:!1,mount:I_,markers:{show:!0,width:2,stroke:hx,fill:ux,dash:"solid"},idx:null,idxs:null,values:[]};function dx(i,t){let e=i.cursor.points,n=oi(),s=e.size(i,t);Oe(n,To,s),Oe(n,Co,s);let r=s/-2;Oe(n,"marginLeft",r),Oe(n,"marginTop",r);let o=e.width(i,t,s);return o&&Oe(n,"borderWidth",o),n}function px(i,t){let e=i.series[t].points;return e._fill||e._stroke}function mx(i,t){let e=i.series[t].points;return e._stroke||e._fill}function gx(i,t){return i.series[t].points.size}var Dc=[0,0];function _x(i,t,e){return Dc[0]=t,Dc[1]=e,Dc}function Sa(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function Uc(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var xx={show:!0,x:!0,y:!0,lock:!1,move:_x,points:{one:!1,show:dx,size:gx,width:0,stroke:mx,fill:px},bind:{mousedown:Sa,mouseup:Sa,click:Sa,dblclick:Sa,mousemove:Uc,mouseleave:Uc,mouseenter:Uc},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Ip={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},th=$e({},Ip,{filter:_p}),Lp=$e({},th,{size:10}),Dp=$e({},Ip,{show:!1}),eh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Up="bold "+eh,Np=1.5,jd={show:!0,scale:"x",stroke:Xc,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Up,side:2,grid:th,ticks:Lp,border:Dp,font:eh,lineGap:Np,rotate:0},yx="Value",vx="Time",Qd={show:!0,scale:"x",auto:!1,sorted:1,min:Ce,max:-Ce,idxs:[]};function Mx(i,t,e,n,s){return t.map(r=>r==null?"":Kc(r))}function bx(i,t,e,n,s,r,o){let a=[],l=ms.get(s)||0;e=o?e:Re(Pa(e,s),l);for(let c=e;c<=n;c=Re(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function zc(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?$i:pp,h=qn(c(e));s=wr(l,h),l==10&&(s=ks[gi(s,ks)]);let u=e,f=s*l;l==10&&(f=ks[gi(f,ks)]);do a.push(u),u=u+s,l==10&&!ms.has(u)&&(u=Re(u,ms.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=ks[gi(f,ks)]));while(u<=n);return a}function Sx(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?zc(i,t,In(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?zc(i,t,In(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(h,c)}var Op=/./,wx=/[12357]/,Ex=/[125]/,tp=/1/,Vc=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Ax(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Op:l(7,o)-h>=c?wx:l(5,o)-h>=c?Ex:tp;if(u==tp){let f=tn(l(1,o)-h);if(f<c)return Vc(t.slice().reverse(),a.distr,u,ai(c/f)).reverse()}return Vc(t,a.distr,u,1)}function Tx(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=tn(l(1,o)-l(2,o));return c<a?Vc(t.slice().reverse(),3,Op,ai(a/c)).reverse():t}function Cx(i,t,e,n){return n==null?qc:t==null?"":Kc(t)}var ep={show:!0,scale:"y",stroke:Xc,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Up,side:3,grid:th,ticks:Lp,border:Dp,font:eh,lineGap:Np,rotate:0};function Rx(i,t){let e=3+(i||1)*2;return Re(e*t,3)}function Px(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=tn(o-r),l=i.series[t],c=a/(l.points.space*ye);return n[1]-n[0]<=c}var np={scale:null,auto:!0,sorted:0,min:Ce,max:-Ce},Fp=(i,t,e,n,s)=>s,ip={show:!0,auto:!0,sorted:0,gaps:Fp,alpha:1,facets:[$e({},np,{scale:"x"}),$e({},np,{scale:"y"})]},sp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Fp,alpha:1,points:{show:Px,filter:null},values:null,min:Ce,max:-Ce,idxs:[],path:null,clip:null};function Ix(i,t,e,n,s){return e/10}var kp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Lx=$e({},kp,{time:!1,ori:1}),rp={};function Bp(i,t){let e=rp[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(rp[i]=e)),e}var Tr=1<<0,Hc=1<<1;function Hs(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,p=a.top,g=a.width,x=a.height,m=i.valToPosH,d=i.valToPosV;return h.ori==0?e(s,l,c,h,u,m,d,f,p,g,x,Da,Rr,Na,Vp,Gp):e(s,l,c,h,u,d,m,p,f,x,g,Ua,Pr,sh,Hp,Wp)}function nh(i,t){let e=0,n=0,s=ge(i.bands,Jc);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Dx(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Zi(i,t,e,n,s,r){return Hs(i,t,(o,a,l,c,h,u,f,p,g,x,m)=>{let d=o.pxRound,M=c.dir*(c.ori==0?1:-1),b=c.ori==0?Rr:Pr,y,U;M==1?(y=e,U=n):(y=n,U=e);let C=d(u(a[y],c,x,p)),D=d(f(l[y],h,m,g)),O=d(u(a[U],c,x,p)),A=d(f(r==1?h.max:h.min,h,m,g)),S=new Path2D(s);return b(S,O,A),b(S,C,A),b(S,C,D),S})}function La(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?Na:sh,l=e;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,n,p,n+r),l=f[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Ux(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function ih(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let p=r(i[u]),g=f==u?p:r(i[f]),x=u-s;p=o<=0&&x>=0&&x<l?r(i[x]):p;let d=f+s;g=o>=0&&d>=0&&d<l?r(i[d]):g,g>=p&&a.push([p,g])}return a}function op(i){return i==0?gp:i==1?Qe:t=>Fs(t,i)}function zp(i){let t=i==0?Da:Ua,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=_i(c,a/2,l/2),h=_i(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var Da=(i,t,e)=>{i.moveTo(t,e)},Ua=(i,t,e)=>{i.moveTo(e,t)},Rr=(i,t,e)=>{i.lineTo(t,e)},Pr=(i,t,e)=>{i.lineTo(e,t)},Na=zp(0),sh=zp(1),Vp=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},Hp=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},Gp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},Wp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function Xp(i){return(t,e,n,s,r)=>Hs(t,e,(o,a,l,c,h,u,f,p,g,x,m)=>{let{pxRound:d,points:M}=o,b,y;c.ori==0?(b=Da,y=Vp):(b=Ua,y=Hp);let U=Re(M.width*ye,3),C=(M.size-M.width)/2*ye,D=Re(C*2,3),O=new Path2D,A=new Path2D,{left:S,top:R,width:G,height:F}=t.bbox;Na(A,S-D,R-D,G+D*2,F+D*2);let W=J=>{if(l[J]!=null){let K=d(u(a[J],c,x,p)),Q=d(f(l[J],h,m,g));b(O,K+C,Q),y(O,K,Q,C,0,wa*2)}};if(r)r.forEach(W);else for(let J=n;J<=s;J++)W(J);return{stroke:U>0?O:null,fill:O,clip:A,flags:Tr|Hc}})}function qp(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var Nx=qp(Rr),Ox=qp(Pr);function Yp(i){let t=ge(i?.alignGaps,0);return(e,n,s,r)=>Hs(e,n,(o,a,l,c,h,u,f,p,g,x,m)=>{[s,r]=Ca(l,s,r);let d=o.pxRound,M=F=>d(u(F,c,x,p)),b=F=>d(f(F,h,m,g)),y,U;c.ori==0?(y=Rr,U=Nx):(y=Pr,U=Ox);let C=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Tr},O=D.stroke,A=!1;if(r-s>=x*4){let F=pt=>e.posToVal(pt,c.key,!0),W=null,J=null,K,Q,tt,ut=M(a[C==1?s:r]),ct=M(a[s]),mt=M(a[r]),vt=F(C==1?ct+1:mt-1);for(let pt=C==1?s:r;pt>=s&&pt<=r;pt+=C){let it=a[pt],gt=(C==1?it<vt:it>vt)?ut:M(it),ot=l[pt];gt==ut?ot!=null?(Q=ot,W==null?(y(O,gt,b(Q)),K=W=J=Q):Q<W?W=Q:Q>J&&(J=Q)):ot===null&&(A=!0):(W!=null&&U(O,ut,b(W),b(J),b(K),b(Q)),ot!=null?(Q=ot,y(O,gt,b(Q)),W=J=K=Q):(W=J=null,ot===null&&(A=!0)),ut=gt,vt=F(ut+C))}W!=null&&W!=J&&tt!=ut&&U(O,ut,b(W),b(J),b(K),b(Q))}else for(let F=C==1?s:r;F>=s&&F<=r;F+=C){let W=l[F];W===null?A=!0:W!=null&&y(O,M(a[F]),b(W))}let[R,G]=nh(e,n);if(o.fill!=null||R!=0){let F=D.fill=new Path2D(O),W=o.fillTo(e,n,o.min,o.max,R),J=b(W),K=M(a[s]),Q=M(a[r]);C==-1&&([Q,K]=[K,Q]),y(F,Q,J),y(F,K,J)}if(!o.spanGaps){let F=[];A&&F.push(...ih(a,l,s,r,C,M,t)),D.gaps=F=o.gaps(e,n,s,r,F),D.clip=La(F,c.ori,p,g,x,m)}return G!=0&&(D.band=G==2?[Zi(e,n,s,r,O,-1),Zi(e,n,s,r,O,1)]:Zi(e,n,s,r,O,G)),D})}function Fx(i){let t=ge(i.align,1),e=ge(i.ascDesc,!1),n=ge(i.alignGaps,0),s=ge(i.extend,!1);return(r,o,a,l)=>Hs(r,o,(c,h,u,f,p,g,x,m,d,M,b)=>{[a,l]=Ca(u,a,l);let y=c.pxRound,{left:U,width:C}=r.bbox,D=ct=>y(g(ct,f,M,m)),O=ct=>y(x(ct,p,b,d)),A=f.ori==0?Rr:Pr,S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Tr},R=S.stroke,G=f.dir*(f.ori==0?1:-1),F=O(u[G==1?a:l]),W=D(h[G==1?a:l]),J=W,K=W;s&&t==-1&&(K=U,A(R,K,F)),A(R,W,F);for(let ct=G==1?a:l;ct>=a&&ct<=l;ct+=G){let mt=u[ct];if(mt==null)continue;let vt=D(h[ct]),pt=O(mt);t==1?A(R,vt,F):A(R,J,pt),A(R,vt,pt),F=pt,J=vt}let Q=J;s&&t==1&&(Q=U+C,A(R,Q,F));let[tt,ut]=nh(r,o);if(c.fill!=null||tt!=0){let ct=S.fill=new Path2D(R),mt=c.fillTo(r,o,c.min,c.max,tt),vt=O(mt);A(ct,Q,vt),A(ct,K,vt)}if(!c.spanGaps){let ct=[];ct.push(...ih(h,u,a,l,G,D,n));let mt=c.width*ye/2,vt=e||t==1?mt:-mt,pt=e||t==-1?-mt:mt;ct.forEach(it=>{it[0]+=vt,it[1]+=pt}),S.gaps=ct=c.gaps(r,o,a,l,ct),S.clip=La(ct,f.ori,m,d,M,b)}return ut!=0&&(S.band=ut==2?[Zi(r,o,a,l,R,-1),Zi(r,o,a,l,R,1)]:Zi(r,o,a,l,R,ut)),S})}function ap(i,t,e,n,s,r,o=Ce){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=tn(i[l]-i[a]);h<c&&(c=h,o=tn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function kx(i){i=i||Io;let t=ge(i.size,[.6,Ce,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ae(s),o=1-t[0],a=ge(t[1],Ce),l=ge(t[2],1),c=ge(i.disp,Io),h=ge(i.each,p=>{}),{fill:u,stroke:f}=c;return(p,g,x,m)=>Hs(p,g,(d,M,b,y,U,C,D,O,A,S,R)=>{let G=d.pxRound,F=e,W=n*ye,J=a*ye,K=l*ye,Q,tt;y.ori==0?[Q,tt]=r(p,g):[tt,Q]=r(p,g);let ut=y.dir*(y.ori==0?1:-1),ct=y.ori==0?Na:sh,mt=y.ori==0?h:(X,et,Mt,_t,Et,Zt,ft)=>{h(X,et,Mt,Et,_t,ft,Zt)},vt=ge(p.bands,Jc).find(X=>X.series[0]==g),pt=vt!=null?vt.dir:0,it=d.fillTo(p,g,d.min,d.max,pt),at=G(D(it,U,R,A)),gt,ot,Bt,Ht=S,Ut=G(d.width*ye),ce=!1,Kt=null,he=null,V=null,Je=null;u!=null&&(Ut==0||f!=null)&&(ce=!0,Kt=u.values(p,g,x,m),he=new Map,new Set(Kt).forEach(X=>{X!=null&&he.set(X,new Path2D)}),Ut>0&&(V=f.values(p,g,x,m),Je=new Map,new Set(V).forEach(X=>{X!=null&&Je.set(X,new Path2D)})));let{x0:te,size:ee}=c;if(te!=null&&ee!=null){F=1,M=te.values(p,g,x,m),te.unit==2&&(M=M.map(Mt=>p.posToVal(O+Mt*S,y.key,!0)));let X=ee.values(p,g,x,m);ee.unit==2?ot=X[0]*S:ot=C(X[0],y,S,O)-C(0,y,S,O),Ht=ap(M,b,C,y,S,O,Ht),Bt=Ht-ot+W}else Ht=ap(M,b,C,y,S,O,Ht),Bt=Ht*o+W,ot=Ht-Bt;Bt<1&&(Bt=0),Ut>=ot/2&&(Ut=0),Bt<5&&(G=gp);let Gt=Bt>0,fe=Ht-Bt-(Gt?Ut:0);ot=G(Bc(fe,K,J)),gt=(F==0?ot/2:F==ut?0:ot)-F*ut*((F==0?W/2:0)+(Gt?Ut/2:0));let Pt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},P=ce?null:new Path2D,w=null;if(vt!=null)w=p.data[vt.series[1]];else{let{y0:X,y1:et}=c;X!=null&&et!=null&&(b=et.values(p,g,x,m),w=X.values(p,g,x,m))}let Z=Q*ot,j=tt*ot;for(let X=ut==1?x:m;X>=x&&X<=m;X+=ut){let et=b[X];if(et==null)continue;if(w!=null){let Ft=w[X]??0;if(et-Ft==0)continue;at=D(Ft,U,R,A)}let Mt=y.distr!=2||c!=null?M[X]:X,_t=C(Mt,y,S,O),Et=D(ge(et,it),U,R,A),Zt=G(_t-gt),ft=G(In(Et,at)),xt=G(_i(Et,at)),Nt=ft-xt;if(et!=null){let Ft=et<0?j:Z,St=et<0?Z:j;ce?(Ut>0&&V[X]!=null&&ct(Je.get(V[X]),Zt,xt+qn(Ut/2),ot,In(0,Nt-Ut),Ft,St),Kt[X]!=null&&ct(he.get(Kt[X]),Zt,xt+qn(Ut/2),ot,In(0,Nt-Ut),Ft,St)):ct(P,Zt,xt+qn(Ut/2),ot,In(0,Nt-Ut),Ft,St),mt(p,g,X,Zt-Ut/2,xt,ot+Ut,Nt)}}return Ut>0?Pt.stroke=ce?Je:P:ce||(Pt._fill=d.width==0?d._fill:d._stroke??d._fill,Pt.width=0),Pt.fill=ce?he:P,Pt})}function Bx(i,t){let e=ge(t?.alignGaps,0);return(n,s,r,o)=>Hs(n,s,(a,l,c,h,u,f,p,g,x,m,d)=>{[r,o]=Ca(c,r,o);let M=a.pxRound,b=Q=>M(f(Q,h,m,g)),y=Q=>M(p(Q,u,d,x)),U,C,D;h.ori==0?(U=Da,D=Rr,C=Gp):(U=Ua,D=Pr,C=Wp);let O=h.dir*(h.ori==0?1:-1),A=b(l[O==1?r:o]),S=A,R=[],G=[];for(let Q=O==1?r:o;Q>=r&&Q<=o;Q+=O)if(c[Q]!=null){let ut=l[Q],ct=b(ut);R.push(S=ct),G.push(y(c[Q]))}let F={stroke:i(R,G,U,D,C,M),fill:null,clip:null,band:null,gaps:null,flags:Tr},W=F.stroke,[J,K]=nh(n,s);if(a.fill!=null||J!=0){let Q=F.fill=new Path2D(W),tt=a.fillTo(n,s,a.min,a.max,J),ut=y(tt);D(Q,S,ut),D(Q,A,ut)}if(!a.spanGaps){let Q=[];Q.push(...ih(l,c,r,o,O,b,e)),F.gaps=Q=a.gaps(n,s,r,o,Q),F.clip=La(Q,h.ori,g,x,m,d)}return K!=0&&(F.band=K==2?[Zi(n,s,r,o,W,-1),Zi(n,s,r,o,W,1)]:Zi(n,s,r,o,W,K)),F})}function zx(i){return Bx(Vx,i)}function Vx(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+u[f]/3,t[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,t[f+1]-l[f+1]*u[f]/3,i[f+1],t[f+1])}return a}var Gc=new Set;function lp(){for(let i of Gc)i.syncRect(!0)}Cr&&(zs(M_,Sr,lp),zs(b_,Sr,lp,!0),zs(Ea,Sr,()=>{pn.pxRatio=ye}));var Hx=Yp(),Gx=Xp();function cp(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Wc(r,o,t,e))}function Wx(i,t){return i.map((e,n)=>n==0?{}:$e({},t,e))}function Wc(i,t,e,n){return $e({},t==0?e:n,i)}function $p(i,t,e){return t==null?Er:[t,e]}var Xx=$p;function qx(i,t,e){return t==null?Er:Aa(t,e,Zc,!0)}function Zp(i,t,e,n){return t==null?Er:Ra(t,e,i.scales[n].log,!1)}var Yx=Zp;function Kp(i,t,e,n){return t==null?Er:$c(t,e,i.scales[n].log,!1)}var $x=Kp;function Zx(i,t,e,n,s){let r=In(Vd(i),Vd(t)),o=t-i,a=gi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?ms.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function hp(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=Qe((e=+s)*ye))+"px"),[i,t,e]}function Kx(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Re(t[2]*ye,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function pn(i,t,e){let n={mode:ge(i.mode,1)},s=n.mode;function r(_,v,T,I){let k=v.valToPct(_);return I+T*(v.dir==-1?1-k:k)}function o(_,v,T,I){let k=v.valToPct(_);return I+T*(v.dir==-1?k:1-k)}function a(_,v,T,I){return v.ori==0?r(_,v,T,I):o(_,v,T,I)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=oi(i_);if(i.id!=null&&(c.id=i.id),Xn(c,i.class),i.title){let _=oi(o_,c);_.textContent=i.title}let h=mi("canvas"),u=n.ctx=h.getContext("2d"),f=oi(a_,c);zs("click",f,_=>{_.target===g&&(De!=pr||Be!=mr)&&gn.click(n,_)},!0);let p=n.under=oi(l_,f);f.appendChild(h);let g=n.over=oi(c_,f);i=Ar(i);let x=+ge(i.pxAlign,1),m=op(x);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let d=i.ms||.001,M=n.series=s==1?cp(i.series||[],Qd,sp,!1):Wx(i.series||[null],ip),b=n.axes=cp(i.axes||[],jd,ep,!0),y=n.scales={},U=n.bands=i.bands||[];U.forEach(_=>{_.fill=ae(_.fill||null),_.dir=ge(_.dir,-1)});let C=s==2?M[1].facets[0].scale:M[0].scale,D={axes:v0,series:ei},O=(i.drawOrder||["axes","series"]).map(_=>D[_]);function A(_){let v=_.distr==3?T=>$i(T>0?T:_.clamp(n,T,_.min,_.max,_.key)):_.distr==4?T=>Ic(T,_.asinh):_.distr==100?T=>_.fwd(T):T=>T;return T=>{let I=v(T),{_min:k,_max:$}=_,st=$-k;return(I-k)/st}}function S(_){let v=y[_];if(v==null){let T=(i.scales||Io)[_]||Io;if(T.from!=null){S(T.from);let I=$e({},y[T.from],T,{key:_});I.valToPct=A(I),y[_]=I}else{v=y[_]=$e({},_==C?kp:Lx,T),v.key=_;let I=v.time,k=v.range,$=ps(k);if((_!=C||s==2&&!I)&&($&&(k[0]==null||k[1]==null)&&(k={min:k[0]==null?kd:{mode:1,hard:k[0],soft:k[0]},max:k[1]==null?kd:{mode:1,hard:k[1],soft:k[1]}},$=!1),!$&&Ia(k))){let st=k;k=(lt,dt,Ct)=>dt==null?Er:Aa(dt,Ct,st)}v.range=ae(k||(I?Xx:_==C?v.distr==3?Yx:v.distr==4?$x:$p:v.distr==3?Zp:v.distr==4?Kp:qx)),v.auto=ae($?!1:v.auto),v.clamp=ae(v.clamp||Ix),v._min=v._max=null,v.valToPct=A(v)}}}S("x"),S("y"),s==1&&M.forEach(_=>{S(_.scale)}),b.forEach(_=>{S(_.scale)});for(let _ in i.scales)S(_);let R=y[C],G=R.distr,F,W;R.ori==0?(Xn(c,s_),F=r,W=o):(Xn(c,r_),F=o,W=r);let J={};for(let _ in y){let v=y[_];(v.min!=null||v.max!=null)&&(J[_]={min:v.min,max:v.max},v.min=v.max=null)}let K=i.tzDate||(_=>new Date(Qe(_/d))),Q=i.fmtDate||jc,tt=d==1?sx(K):ax(K),ut=Zd(K,$d(d==1?ix:ox,Q)),ct=Jd(K,Kd(cx,Q)),mt=[],vt=n.legend=$e({},fx,i.legend),pt=n.cursor=$e({},xx,{drag:{y:s==2}},i.cursor),it=vt.show,at=pt.show,gt=vt.markers;vt.idxs=mt,gt.width=ae(gt.width),gt.dash=ae(gt.dash),gt.stroke=ae(gt.stroke),gt.fill=ae(gt.fill);let ot,Bt,Ht,Ut=[],ce=[],Kt,he=!1,V={};if(vt.live){let _=M[1]?M[1].values:null;he=_!=null,Kt=he?_(n,1,0):{_:0};for(let v in Kt)V[v]=qc}if(it)if(ot=mi("table",m_,c),Ht=mi("tbody",null,ot),vt.mount(n,ot),he){Bt=mi("thead",null,ot,Ht);let _=mi("tr",null,Bt);mi("th",null,_);for(var Je in Kt)mi("th",Ed,_).textContent=Je}else Xn(ot,__),vt.live&&Xn(ot,g_);let te={show:!0},ee={show:!1};function Gt(_,v){if(v==0&&(he||!vt.live||s==2))return Er;let T=[],I=mi("tr",x_,Ht,Ht.childNodes[v]);Xn(I,_.class),_.show||Xn(I,Bs);let k=mi("th",null,I);if(gt.show){let lt=oi(y_,k);if(v>0){let dt=gt.width(n,v);dt&&(lt.style.border=dt+"px "+gt.dash(n,v)+" "+gt.stroke(n,v)),lt.style.background=gt.fill(n,v)}}let $=oi(Ed,k);_.label instanceof HTMLElement?$.appendChild(_.label):$.textContent=_.label,v>0&&(gt.show||($.style.color=_.width>0?gt.stroke(n,v):gt.fill(n,v)),Pt("click",k,lt=>{if(pt._lock)return;je(lt);let dt=M.indexOf(_);if((lt.ctrlKey||lt.metaKey)!=vt.isolate){let Ct=M.some((Rt,It)=>It>0&&It!=dt&&Rt.show);M.forEach((Rt,It)=>{It>0&&Di(It,Ct?It==dt?te:ee:te,!0,Ye.setSeries)})}else Di(dt,{show:!_.show},!0,Ye.setSeries)},!1),Wi&&Pt(Rd,k,lt=>{pt._lock||(je(lt),Di(M.indexOf(_),_r,!0,Ye.setSeries))},!1));for(var st in Kt){let lt=mi("td",v_,I);lt.textContent="--",T.push(lt)}return[I,T]}let fe=new Map;function Pt(_,v,T,I=!0){let k=fe.get(v)||{},$=pt.bind[_](n,v,T,I);$&&(zs(_,v,k[_]=$),fe.set(v,k))}function P(_,v,T){let I=fe.get(v)||{};for(let k in I)(_==null||k==_)&&(kc(k,v,I[k]),delete I[k]);_==null&&fe.delete(v)}let w=0,Z=0,j=0,X=0,et=0,Mt=0,_t=et,Et=Mt,Zt=j,ft=X,xt=0,Nt=0,Ft=0,St=0;n.bbox={};let ie=!1,Yt=!1,de=!1,z=!1,yt=!1,nt=!1;function rt(_,v,T){(T||_!=n.width||v!=n.height)&&At(_,v),hr(!1),de=!0,Yt=!0,ur()}function At(_,v){n.width=w=j=_,n.height=Z=X=v,et=Mt=0,an(),_e();let T=n.bbox;xt=T.left=Fs(et*ye,.5),Nt=T.top=Fs(Mt*ye,.5),Ft=T.width=Fs(j*ye,.5),St=T.height=Fs(X*ye,.5)}let Tt=3;function Jt(){let _=!1,v=0;for(;!_;){v++;let T=x0(v),I=y0(v);_=v==Tt||T&&I,_||(At(n.width,n.height),Yt=!0)}}function Fe({width:_,height:v}){rt(_,v)}n.setSize=Fe;function an(){let _=!1,v=!1,T=!1,I=!1;b.forEach((k,$)=>{if(k.show&&k._show){let{side:st,_size:lt}=k,dt=st%2,Ct=k.label!=null?k.labelSize:0,Rt=lt+Ct;Rt>0&&(dt?(j-=Rt,st==3?(et+=Rt,I=!0):T=!0):(X-=Rt,st==0?(Mt+=Rt,_=!0):v=!0))}}),Pi[0]=_,Pi[1]=T,Pi[2]=v,Pi[3]=I,j-=E[1]+E[3],et+=E[3],X-=E[2]+E[0],Mt+=E[0]}function _e(){let _=et+j,v=Mt+X,T=et,I=Mt;function k($,st){switch($){case 1:return _+=st,_-st;case 2:return v+=st,v-st;case 3:return T-=st,T+st;case 0:return I-=st,I+st}}b.forEach(($,st)=>{if($.show&&$._show){let lt=$.side;$._pos=k(lt,$._size),$.label!=null&&($._lpos=k(lt,$.labelSize))}})}if(pt.dataIdx==null){let _=pt.hover,v=_.skip=new Set(_.skip??[]);v.add(void 0);let T=_.prox=ae(_.prox),I=_.bias??(_.bias=0);pt.dataIdx=(k,$,st,lt)=>{if($==0)return st;let dt=st,Ct=T(k,$,st,lt)??Ce,Rt=Ct>=0&&Ct<Ce,It=R.ori==0?j:X,$t=pt.left,xe=t[0],me=t[$];if(v.has(me[st])){dt=null;let re=null,Xt=null,Vt;if(I==0||I==-1)for(Vt=st;re==null&&Vt-- >0;)v.has(me[Vt])||(re=Vt);if(I==0||I==1)for(Vt=st;Xt==null&&Vt++<me.length;)v.has(me[Vt])||(Xt=Vt);if(re!=null||Xt!=null)if(Rt){let Ne=re==null?-1/0:F(xe[re],R,It,0),Ge=Xt==null?1/0:F(xe[Xt],R,It,0),fn=$t-Ne,we=Ge-$t;fn<=we?fn<=Ct&&(dt=re):we<=Ct&&(dt=Xt)}else dt=Xt==null?re:re==null?Xt:st-re<=Xt-st?re:Xt}else Rt&&tn($t-F(xe[st],R,It,0))>Ct&&(dt=null);return dt}}let je=_=>{pt.event=_};pt.idxs=mt,pt._lock=!1;let Ie=pt.points;Ie.show=ae(Ie.show),Ie.size=ae(Ie.size),Ie.stroke=ae(Ie.stroke),Ie.width=ae(Ie.width),Ie.fill=ae(Ie.fill);let Vn=n.focus=$e({},i.focus||{alpha:.3},pt.focus),Wi=Vn.prox>=0,Nn=Wi&&Ie.one,xn=[],Xi=[],qi=[];function Ps(_,v){let T=Ie.show(n,v);if(T instanceof HTMLElement)return Xn(T,p_),Xn(T,_.class),ki(T,-10,-10,j,X),g.insertBefore(T,xn[v]),T}function mo(_,v){if(s==1||v>0){let T=s==1&&y[_.scale].time,I=_.value;_.value=T?Wd(I)?Jd(K,Kd(I,Q)):I||ct:I||Cx,_.label=_.label||(T?vx:yx)}if(Nn||v>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Hx||L_,_.fillTo=ae(_.fillTo||Dx),_.pxAlign=+ge(_.pxAlign,x),_.pxRound=op(_.pxAlign),_.stroke=ae(_.stroke||null),_.fill=ae(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let T=Rx(In(1,_.width),1),I=_.points=$e({},{size:T,width:In(1,T*.2),stroke:_.stroke,space:T*2,paths:Gx,_stroke:null,_fill:null},_.points);I.show=ae(I.show),I.filter=ae(I.filter),I.fill=ae(I.fill),I.stroke=ae(I.stroke),I.paths=ae(I.paths),I.pxAlign=_.pxAlign}if(it){let T=Gt(_,v);Ut.splice(v,0,T[0]),ce.splice(v,0,T[1]),vt.values.push(null)}if(at){mt.splice(v,0,null);let T=null;Nn?v==0&&(T=Ps(_,v)):v>0&&(T=Ps(_,v)),xn.splice(v,0,T),Xi.splice(v,0,0),qi.splice(v,0,0)}un("addSeries",v)}function lr(_,v){v=v??M.length,_=s==1?Wc(_,v,Qd,sp):Wc(_,v,{},ip),M.splice(v,0,_),mo(M[v],v)}n.addSeries=lr;function oa(_){if(M.splice(_,1),it){vt.values.splice(_,1),ce.splice(_,1);let v=Ut.splice(_,1)[0];P(null,v.firstChild),v.remove()}at&&(mt.splice(_,1),xn.splice(_,1)[0].remove(),Xi.splice(_,1),qi.splice(_,1)),un("delSeries",_)}n.delSeries=oa;let Pi=[!1,!1,!1,!1];function hc(_,v){if(_._show=_.show,_.show){let T=_.side%2,I=y[_.scale];I==null&&(_.scale=T?M[1].scale:C,I=y[_.scale]);let k=I.time;_.size=ae(_.size),_.space=ae(_.space),_.rotate=ae(_.rotate),ps(_.incrs)&&_.incrs.forEach(st=>{!ms.has(st)&&ms.set(st,yp(st))}),_.incrs=ae(_.incrs||(I.distr==2?tx:k?d==1?nx:rx:ks)),_.splits=ae(_.splits||(k&&I.distr==1?tt:I.distr==3?zc:I.distr==4?Sx:bx)),_.stroke=ae(_.stroke),_.grid.stroke=ae(_.grid.stroke),_.ticks.stroke=ae(_.ticks.stroke),_.border.stroke=ae(_.border.stroke);let $=_.values;_.values=ps($)&&!ps($[0])?ae($):k?ps($)?Zd(K,$d($,Q)):Wd($)?lx(K,$):$||ut:$||Mx,_.filter=ae(_.filter||(I.distr>=3&&I.log==10?Ax:I.distr==3&&I.log==2?Tx:_p)),_.font=hp(_.font),_.labelFont=hp(_.labelFont),_._size=_.size(n,null,v,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Pi[v]=!0,_._el=oi(h_,f))}}function Is(_,v,T,I){let[k,$,st,lt]=T,dt=v%2,Ct=0;return dt==0&&(lt||$)&&(Ct=v==0&&!k||v==2&&!st?Qe(jd.size/3):0),dt==1&&(k||st)&&(Ct=v==1&&!$||v==3&&!lt?Qe(ep.size/2):0),Ct}let aa=n.padding=(i.padding||[Is,Is,Is,Is]).map(_=>ae(ge(_,Is))),E=n._padding=aa.map((_,v)=>_(n,v,Pi,0)),B,q=null,Y=null,H=s==1?M[0].idxs:null,ht=null,bt=!1;function Ot(_,v){if(t=_??[],n.data=n._data=t,s==2){B=0;for(let T=1;T<M.length;T++)B+=t[T][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ht=t[0],B=ht.length;let T=t;if(G==2){T=t.slice();let I=T[0]=Array(B);for(let k=0;k<B;k++)I[k]=k}n._data=t=T}if(hr(!0),un("setData"),G==2&&(de=!0),v!==!1){let T=R;T.auto(n,bt)?Lt():hs(C,T.min,T.max),z=z||pt.left>=0,nt=!0,ur()}}n.setData=Ot;function Lt(){bt=!0;let _,v;s==1&&(B>0?(q=H[0]=0,Y=H[1]=B-1,_=t[0][q],v=t[0][Y],G==2?(_=q,v=Y):_==v&&(G==3?[_,v]=Ra(_,_,R.log,!1):G==4?[_,v]=$c(_,_,R.log,!1):R.time?v=_+Qe(86400/d):[_,v]=Aa(_,v,Zc,!0))):(q=H[0]=_=null,Y=H[1]=v=null)),hs(C,_,v)}let Wt,qt,Dt,oe,ve,Se,ln,ue,kt,ke;function pe(_,v,T,I,k,$){_??(_=Td),T??(T=Jc),I??(I="butt"),k??(k=Td),$??($="round"),_!=Wt&&(u.strokeStyle=Wt=_),k!=qt&&(u.fillStyle=qt=k),v!=Dt&&(u.lineWidth=Dt=v),$!=ve&&(u.lineJoin=ve=$),I!=Se&&(u.lineCap=Se=I),T!=oe&&u.setLineDash(oe=T)}function On(_,v,T,I){v!=qt&&(u.fillStyle=qt=v),_!=ln&&(u.font=ln=_),T!=ue&&(u.textAlign=ue=T),I!=kt&&(u.textBaseline=kt=I)}function Ii(_,v,T,I,k=0){if(I.length>0&&_.auto(n,bt)&&(v==null||v.min==null)){let $=ge(q,0),st=ge(Y,I.length-1),lt=T.min==null?A_(I,$,st,k,_.distr==3):[T.min,T.max];_.min=_i(_.min,T.min=lt[0]),_.max=In(_.max,T.max=lt[1])}}let yn={min:null,max:null};function Ls(){for(let I in y){let k=y[I];J[I]==null&&(k.min==null||J[C]!=null&&k.auto(n,bt))&&(J[I]=yn)}for(let I in y){let k=y[I];J[I]==null&&k.from!=null&&J[k.from]!=null&&(J[I]=yn)}J[C]!=null&&hr(!0);let _={};for(let I in J){let k=J[I];if(k!=null){let $=_[I]=Ar(y[I],N_);if(k.min!=null)$e($,k);else if(I!=C||s==2)if(B==0&&$.from==null){let st=$.range(n,null,null,I);$.min=st[0],$.max=st[1]}else $.min=Ce,$.max=-Ce}}if(B>0){M.forEach((I,k)=>{if(s==1){let $=I.scale,st=J[$];if(st==null)return;let lt=_[$];if(k==0){let dt=lt.range(n,lt.min,lt.max,$);lt.min=dt[0],lt.max=dt[1],q=gi(lt.min,t[0]),Y=gi(lt.max,t[0]),Y-q>1&&(t[0][q]<lt.min&&q++,t[0][Y]>lt.max&&Y--),I.min=ht[q],I.max=ht[Y]}else I.show&&I.auto&&Ii(lt,st,I,t[k],I.sorted);I.idxs[0]=q,I.idxs[1]=Y}else if(k>0&&I.show&&I.auto){let[$,st]=I.facets,lt=$.scale,dt=st.scale,[Ct,Rt]=t[k],It=_[lt],$t=_[dt];It!=null&&Ii(It,J[lt],$,Ct,$.sorted),$t!=null&&Ii($t,J[dt],st,Rt,st.sorted),I.min=st.min,I.max=st.max}});for(let I in _){let k=_[I],$=J[I];if(k.from==null&&($==null||$.min==null)){let st=k.range(n,k.min==Ce?null:k.min,k.max==-Ce?null:k.max,I);k.min=st[0],k.max=st[1]}}}for(let I in _){let k=_[I];if(k.from!=null){let $=_[k.from];if($.min==null)k.min=k.max=null;else{let st=k.range(n,$.min,$.max,I);k.min=st[0],k.max=st[1]}}}let v={},T=!1;for(let I in _){let k=_[I],$=y[I];if($.min!=k.min||$.max!=k.max){$.min=k.min,$.max=k.max;let st=$.distr;$._min=st==3?$i($.min):st==4?Ic($.min,$.asinh):st==100?$.fwd($.min):$.min,$._max=st==3?$i($.max):st==4?Ic($.max,$.asinh):st==100?$.fwd($.max):$.max,v[I]=T=!0}}if(T){M.forEach((I,k)=>{s==2?k>0&&v.y&&(I._paths=null):v[I.scale]&&(I._paths=null)});for(let I in v)de=!0,un("setScale",I);at&&pt.left>=0&&(z=nt=!0)}for(let I in J)J[I]=null}function Te(_){let v=Bc(q-1,0,B-1),T=Bc(Y+1,0,B-1);for(;_[v]==null&&v>0;)v--;for(;_[T]==null&&T<B-1;)T++;return[v,T]}function ei(){if(B>0){let _=M.some(v=>v._focus)&&ke!=Vn.alpha;_&&(u.globalAlpha=ke=Vn.alpha),M.forEach((v,T)=>{if(T>0&&v.show&&(ls(T,!1),ls(T,!0),v._paths==null)){let I=ke;ke!=v.alpha&&(u.globalAlpha=ke=v.alpha);let k=s==2?[0,t[T][0].length-1]:Te(t[T]);v._paths=v.paths(n,T,k[0],k[1]),ke!=I&&(u.globalAlpha=ke=I)}}),M.forEach((v,T)=>{if(T>0&&v.show){let I=ke;ke!=v.alpha&&(u.globalAlpha=ke=v.alpha),v._paths!=null&&En(T,!1);{let k=v._paths!=null?v._paths.gaps:null,$=v.points.show(n,T,q,Y,k),st=v.points.filter(n,T,$,k);($||st)&&(v.points._paths=v.points.paths(n,T,q,Y,st),En(T,!0))}ke!=I&&(u.globalAlpha=ke=I),un("drawSeries",T)}}),_&&(u.globalAlpha=ke=1)}}function ls(_,v){let T=v?M[_].points:M[_];T._stroke=T.stroke(n,_),T._fill=T.fill(n,_)}function En(_,v){let T=v?M[_].points:M[_],{stroke:I,fill:k,clip:$,flags:st,_stroke:lt=T._stroke,_fill:dt=T._fill,_width:Ct=T.width}=T._paths;Ct=Re(Ct*ye,3);let Rt=null,It=Ct%2/2;v&&dt==null&&(dt=Ct>0?"#fff":lt);let $t=T.pxAlign==1&&It>0;if($t&&u.translate(It,It),!v){let xe=xt-Ct/2,me=Nt-Ct/2,re=Ft+Ct,Xt=St+Ct;Rt=new Path2D,Rt.rect(xe,me,re,Xt)}v?cr(lt,Ct,T.dash,T.cap,dt,I,k,st,$):Li(_,lt,Ct,T.dash,T.cap,dt,I,k,st,Rt,$),$t&&u.translate(-It,-It)}function Li(_,v,T,I,k,$,st,lt,dt,Ct,Rt){let It=!1;dt!=0&&U.forEach(($t,xe)=>{if($t.series[0]==_){let me=M[$t.series[1]],re=t[$t.series[1]],Xt=(me._paths||Io).band;ps(Xt)&&(Xt=$t.dir==1?Xt[0]:Xt[1]);let Vt,Ne=null;me.show&&Xt&&C_(re,q,Y)?(Ne=$t.fill(n,xe)||$,Vt=me._paths.clip):Xt=null,cr(v,T,I,k,Ne,st,lt,dt,Ct,Rt,Vt,Xt),It=!0}}),It||cr(v,T,I,k,$,st,lt,dt,Ct,Rt)}let fi=Tr|Hc;function cr(_,v,T,I,k,$,st,lt,dt,Ct,Rt,It){pe(_,v,T,I,k),(dt||Ct||It)&&(u.save(),dt&&u.clip(dt),Ct&&u.clip(Ct)),It?(lt&fi)==fi?(u.clip(It),Rt&&u.clip(Rt),ca(k,st),la(_,$,v)):lt&Hc?(ca(k,st),u.clip(It),la(_,$,v)):lt&Tr&&(u.save(),u.clip(It),Rt&&u.clip(Rt),ca(k,st),u.restore(),la(_,$,v)):(ca(k,st),la(_,$,v)),(dt||Ct||It)&&u.restore()}function la(_,v,T){T>0&&(v instanceof Map?v.forEach((I,k)=>{u.strokeStyle=Wt=k,u.stroke(I)}):v!=null&&_&&u.stroke(v))}function ca(_,v){v instanceof Map?v.forEach((T,I)=>{u.fillStyle=qt=I,u.fill(T)}):v!=null&&_&&u.fill(v)}function _0(_,v,T,I){let k=b[_],$;if(I<=0)$=[0,0];else{let st=k._space=k.space(n,_,v,T,I),lt=k._incrs=k.incrs(n,_,v,T,I,st);$=Zx(v,T,lt,I,st)}return k._found=$}function uc(_,v,T,I,k,$,st,lt,dt,Ct){let Rt=st%2/2;x==1&&u.translate(Rt,Rt),pe(lt,st,dt,Ct,lt),u.beginPath();let It,$t,xe,me,re=k+(I==0||I==3?-$:$);T==0?($t=k,me=re):(It=k,xe=re);for(let Xt=0;Xt<_.length;Xt++)v[Xt]!=null&&(T==0?It=xe=_[Xt]:$t=me=_[Xt],u.moveTo(It,$t),u.lineTo(xe,me));u.stroke(),x==1&&u.translate(-Rt,-Rt)}function x0(_){let v=!0;return b.forEach((T,I)=>{if(!T.show)return;let k=y[T.scale];if(k.min==null){T._show&&(v=!1,T._show=!1,hr(!1));return}else T._show||(v=!1,T._show=!0,hr(!1));let $=T.side,st=$%2,{min:lt,max:dt}=k,[Ct,Rt]=_0(I,lt,dt,st==0?j:X);if(Rt==0)return;let It=k.distr==2,$t=T._splits=T.splits(n,I,lt,dt,Ct,Rt,It),xe=k.distr==2?$t.map(Vt=>ht[Vt]):$t,me=k.distr==2?ht[$t[1]]-ht[$t[0]]:Ct,re=T._values=T.values(n,T.filter(n,xe,I,Rt,me),I,Rt,me);T._rotate=$==2?T.rotate(n,re,I,Rt):0;let Xt=T._size;T._size=ai(T.size(n,re,I,_)),Xt!=null&&T._size!=Xt&&(v=!1)}),v}function y0(_){let v=!0;return aa.forEach((T,I)=>{let k=T(n,I,Pi,_);k!=E[I]&&(v=!1),E[I]=k}),v}function v0(){for(let _=0;_<b.length;_++){let v=b[_];if(!v.show||!v._show)continue;let T=v.side,I=T%2,k,$,st=v.stroke(n,_),lt=T==0||T==3?-1:1,[dt,Ct]=v._found;if(v.label!=null){let Tn=v.labelGap*lt,Wn=Qe((v._lpos+Tn)*ye);On(v.labelFont[0],st,"center",T==2?Eo:Ad),u.save(),I==1?(k=$=0,u.translate(Wn,Qe(Nt+St/2)),u.rotate((T==3?-wa:wa)/2)):(k=Qe(xt+Ft/2),$=Wn);let Ns=mp(v.label)?v.label(n,_,dt,Ct):v.label;u.fillText(Ns,k,$),u.restore()}if(Ct==0)continue;let Rt=y[v.scale],It=I==0?Ft:St,$t=I==0?xt:Nt,xe=v._splits,me=Rt.distr==2?xe.map(Tn=>ht[Tn]):xe,re=Rt.distr==2?ht[xe[1]]-ht[xe[0]]:dt,Xt=v.ticks,Vt=v.border,Ne=Xt.show?Xt.size:0,Ge=Qe(Ne*ye),fn=Qe((v.alignTo==2?v._size-Ne-v.gap:v.gap)*ye),we=v._rotate*-wa/180,We=m(v._pos*ye),Hn=(Ge+fn)*lt,An=We+Hn;$=I==0?An:0,k=I==1?An:0;let ni=v.font[0],di=v.align==1?Mr:v.align==2?Cc:we>0?Mr:we<0?Cc:I==0?"center":T==3?Cc:Mr,Ni=we||I==1?"middle":T==2?Eo:Ad;On(ni,st,di,Ni);let Gn=v.font[1]*v.lineGap,ii=xe.map(Tn=>m(a(Tn,Rt,It,$t))),pi=v._values;for(let Tn=0;Tn<pi.length;Tn++){let Wn=pi[Tn];if(Wn!=null){I==0?k=ii[Tn]:$=ii[Tn],Wn=""+Wn;let Ns=Wn.indexOf(`
`)==-1?[Wn]:Wn.split(/\n/gm);for(let Cn=0;Cn<Ns.length;Cn++){let td=Ns[Cn];we?(u.save(),u.translate(k,$+Cn*Gn),u.rotate(we),u.fillText(td,0,0),u.restore()):u.fillText(td,k,$+Cn*Gn)}}}Xt.show&&uc(ii,Xt.filter(n,me,_,Ct,re),I,T,We,Ge,Re(Xt.width*ye,3),Xt.stroke(n,_),Xt.dash,Xt.cap);let Oi=v.grid;Oi.show&&uc(ii,Oi.filter(n,me,_,Ct,re),I,I==0?2:1,I==0?Nt:xt,I==0?St:Ft,Re(Oi.width*ye,3),Oi.stroke(n,_),Oi.dash,Oi.cap),Vt.show&&uc([We],[1],I==0?1:0,I==0?1:2,I==1?Nt:xt,I==1?St:Ft,Re(Vt.width*ye,3),Vt.stroke(n,_),Vt.dash,Vt.cap)}un("drawAxes")}function hr(_){M.forEach((v,T)=>{T>0&&(v._paths=null,_&&(s==1?(v.min=null,v.max=null):v.facets.forEach(I=>{I.min=null,I.max=null})))})}let ha=!1,fc=!1,go=[];function M0(){fc=!1;for(let _=0;_<go.length;_++)un(...go[_]);go.length=0}function ur(){ha||(H_(Of),ha=!0)}function b0(_,v=!1){ha=!0,fc=v,_(n),Of(),v&&go.length>0&&queueMicrotask(M0)}n.batch=b0;function Of(){if(ie&&(Ls(),ie=!1),de&&(Jt(),de=!1),Yt){if(Oe(p,Mr,et),Oe(p,Eo,Mt),Oe(p,To,j),Oe(p,Co,X),Oe(g,Mr,et),Oe(g,Eo,Mt),Oe(g,To,j),Oe(g,Co,X),Oe(f,To,w),Oe(f,Co,Z),h.width=Qe(w*ye),h.height=Qe(Z*ye),b.forEach(({_el:_,_show:v,_size:T,_pos:I,side:k})=>{if(_!=null)if(v){let $=k===3||k===0?T:0,st=k%2==1;Oe(_,st?"left":"top",I-$),Oe(_,st?"width":"height",T),Oe(_,st?"top":"left",st?Mt:et),Oe(_,st?"height":"width",st?X:j),Fc(_,Bs)}else Xn(_,Bs)}),Wt=qt=Dt=ve=Se=ln=ue=kt=oe=null,ke=1,yo(!0),et!=_t||Mt!=Et||j!=Zt||X!=ft){hr(!1);let _=j/Zt,v=X/ft;if(at&&!z&&pt.left>=0){pt.left*=_,pt.top*=v,fr&&ki(fr,Qe(pt.left),0,j,X),dr&&ki(dr,0,Qe(pt.top),j,X);for(let T=0;T<xn.length;T++){let I=xn[T];I!=null&&(Xi[T]*=_,qi[T]*=v,ki(I,ai(Xi[T]),ai(qi[T]),j,X))}}if(Ue.show&&!yt&&Ue.left>=0&&Ue.width>0){Ue.left*=_,Ue.width*=_,Ue.top*=v,Ue.height*=v;for(let T in xc)Oe(gr,T,Ue[T])}_t=et,Et=Mt,Zt=j,ft=X}un("setSize"),Yt=!1}w>0&&Z>0&&(u.clearRect(0,0,h.width,h.height),un("drawClear"),O.forEach(_=>_()),un("draw")),Ue.show&&yt&&(ua(Ue),yt=!1),at&&z&&(Us(null,!0,!1),z=!1),vt.show&&vt.live&&nt&&(gc(),nt=!1),l||(l=!0,n.status=1,un("ready")),bt=!1,ha=!1}n.redraw=(_,v)=>{de=v||!1,_!==!1?hs(C,R.min,R.max):ur()};function dc(_,v){let T=y[_];if(T.from==null){if(B==0){let I=T.range(n,v.min,v.max,_);v.min=I[0],v.max=I[1]}if(v.min>v.max){let I=v.min;v.min=v.max,v.max=I}if(B>1&&v.min!=null&&v.max!=null&&v.max-v.min<1e-16)return;_==C&&T.distr==2&&B>0&&(v.min=gi(v.min,t[0]),v.max=gi(v.max,t[0]),v.min==v.max&&v.max++),J[_]=v,ie=!0,ur()}}n.setScale=dc;let pc,mc,fr,dr,Ff,kf,pr,mr,Bf,zf,De,Be,cs=!1,gn=pt.drag,cn=gn.x,hn=gn.y;at&&(pt.x&&(pc=oi(f_,g)),pt.y&&(mc=oi(d_,g)),R.ori==0?(fr=pc,dr=mc):(fr=mc,dr=pc),De=pt.left,Be=pt.top);let Ue=n.select=$e({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),gr=Ue.show?oi(u_,Ue.over?g:p):null;function ua(_,v){if(Ue.show){for(let T in _)Ue[T]=_[T],T in xc&&Oe(gr,T,_[T]);v!==!1&&un("setSelect")}}n.setSelect=ua;function S0(_){if(M[_].show)it&&Fc(Ut[_],Bs);else if(it&&Xn(Ut[_],Bs),at){let T=Nn?xn[0]:xn[_];T!=null&&ki(T,-10,-10,j,X)}}function hs(_,v,T){dc(_,{min:v,max:T})}function Di(_,v,T,I){v.focus!=null&&C0(_),v.show!=null&&M.forEach((k,$)=>{$>0&&(_==$||_==null)&&(k.show=v.show,S0($),s==2?(hs(k.facets[0].scale,null,null),hs(k.facets[1].scale,null,null)):hs(k.scale,null,null),ur())}),T!==!1&&un("setSeries",_,v),I&&vo("setSeries",n,_,v)}n.setSeries=Di;function w0(_,v){$e(U[_],v)}function E0(_,v){_.fill=ae(_.fill||null),_.dir=ge(_.dir,-1),v=v??U.length,U.splice(v,0,_)}function A0(_){_==null?U.length=0:U.splice(_,1)}n.addBand=E0,n.setBand=w0,n.delBand=A0;function T0(_,v){M[_].alpha=v,at&&xn[_]!=null&&(xn[_].style.opacity=v),it&&Ut[_]&&(Ut[_].style.opacity=v)}let Yi,us,Ds,_r={focus:!0};function C0(_){if(_!=Ds){let v=_==null,T=Vn.alpha!=1;M.forEach((I,k)=>{if(s==1||k>0){let $=v||k==0||k==_;I._focus=v?null:$,T&&T0(k,$?1:Vn.alpha)}}),Ds=_,T&&ur()}}it&&Wi&&Pt(Pd,ot,_=>{pt._lock||(je(_),Ds!=null&&Di(null,_r,!0,Ye.setSeries))});function Ui(_,v,T){let I=y[v];T&&(_=_/ye-(I.ori==1?Mt:et));let k=j;I.ori==1&&(k=X,_=k-_),I.dir==-1&&(_=k-_);let $=I._min,st=I._max,lt=_/k,dt=$+(st-$)*lt,Ct=I.distr;return Ct==3?wr(10,dt):Ct==4?P_(dt,I.asinh):Ct==100?I.bwd(dt):dt}function R0(_,v){let T=Ui(_,C,v);return gi(T,t[0],q,Y)}n.valToIdx=_=>gi(_,t[0]),n.posToIdx=R0,n.posToVal=Ui,n.valToPos=(_,v,T)=>y[v].ori==0?r(_,y[v],T?Ft:j,T?xt:0):o(_,y[v],T?St:X,T?Nt:0),n.setCursor=(_,v,T)=>{De=_.left,Be=_.top,Us(null,v,T)};function Vf(_,v){Oe(gr,Mr,Ue.left=_),Oe(gr,To,Ue.width=v)}function Hf(_,v){Oe(gr,Eo,Ue.top=_),Oe(gr,Co,Ue.height=v)}let _o=R.ori==0?Vf:Hf,xo=R.ori==1?Vf:Hf;function P0(){if(it&&vt.live)for(let _=s==2?1:0;_<M.length;_++){if(_==0&&he)continue;let v=vt.values[_],T=0;for(let I in v)ce[_][T++].firstChild.nodeValue=v[I]}}function gc(_,v){if(_!=null&&(_.idxs?_.idxs.forEach((T,I)=>{mt[I]=T}):U_(_.idx)||mt.fill(_.idx),vt.idx=mt[0]),it&&vt.live){for(let T=0;T<M.length;T++)(T>0||s==1&&!he)&&I0(T,mt[T]);P0()}nt=!1,v!==!1&&un("setLegend")}n.setLegend=gc;function I0(_,v){let T=M[_],I=_==0&&G==2?ht:t[_],k;he?k=T.values(n,_,v)??V:(k=T.value(n,v==null?null:I[v],_,v),k=k==null?V:{_:k}),vt.values[_]=k}function Us(_,v,T){Bf=De,zf=Be,[De,Be]=pt.move(n,De,Be),pt.left=De,pt.top=Be,at&&(fr&&ki(fr,Qe(De),0,j,X),dr&&ki(dr,0,Qe(Be),j,X));let I,k=q>Y;Yi=Ce,us=null;let $=R.ori==0?j:X,st=R.ori==1?j:X;if(De<0||B==0||k){I=pt.idx=null;for(let lt=0;lt<M.length;lt++){let dt=xn[lt];dt!=null&&ki(dt,-10,-10,j,X)}Wi&&Di(null,_r,!0,_==null&&Ye.setSeries),vt.live&&(mt.fill(I),nt=!0)}else{let lt,dt,Ct;s==1&&(lt=R.ori==0?De:Be,dt=Ui(lt,C),I=pt.idx=gi(dt,t[0],q,Y),Ct=F(t[0][I],R,$,0));let Rt=-10,It=-10,$t=0,xe=0,me=!0,re="",Xt="";for(let Vt=s==2?1:0;Vt<M.length;Vt++){let Ne=M[Vt],Ge=mt[Vt],fn=Ge==null?null:s==1?t[Vt][Ge]:t[Vt][1][Ge],we=pt.dataIdx(n,Vt,I,dt),We=we==null?null:s==1?t[Vt][we]:t[Vt][1][we];if(nt=nt||We!=fn||we!=Ge,mt[Vt]=we,Vt>0&&Ne.show){let Hn=we==null?-10:we==I?Ct:F(s==1?t[0][we]:t[Vt][0][we],R,$,0),An=We==null?-10:W(We,s==1?y[Ne.scale]:y[Ne.facets[1].scale],st,0);if(Wi&&We!=null){let ni=R.ori==1?De:Be,di=tn(Vn.dist(n,Vt,we,An,ni));if(di<Yi){let Ni=Vn.bias;if(Ni!=0){let Gn=Ui(ni,Ne.scale),ii=We>=0?1:-1,pi=Gn>=0?1:-1;pi==ii&&(pi==1?Ni==1?We>=Gn:We<=Gn:Ni==1?We<=Gn:We>=Gn)&&(Yi=di,us=Vt)}else Yi=di,us=Vt}}if(nt||Nn){let ni,di;R.ori==0?(ni=Hn,di=An):(ni=An,di=Hn);let Ni,Gn,ii,pi,Oi,Tn,Wn=!0,Ns=Ie.bbox;if(Ns!=null){Wn=!1;let Cn=Ns(n,Vt);ii=Cn.left,pi=Cn.top,Ni=Cn.width,Gn=Cn.height}else ii=ni,pi=di,Ni=Gn=Ie.size(n,Vt);if(Tn=Ie.fill(n,Vt),Oi=Ie.stroke(n,Vt),Nn)Vt==us&&Yi<=Vn.prox&&(Rt=ii,It=pi,$t=Ni,xe=Gn,me=Wn,re=Tn,Xt=Oi);else{let Cn=xn[Vt];Cn!=null&&(Xi[Vt]=ii,qi[Vt]=pi,Fd(Cn,Ni,Gn,Wn),Nd(Cn,Tn,Oi),ki(Cn,ai(ii),ai(pi),j,X))}}}}if(Nn){let Vt=Vn.prox,Ne=Ds==null?Yi<=Vt:Yi>Vt||us!=Ds;if(nt||Ne){let Ge=xn[0];Ge!=null&&(Xi[0]=Rt,qi[0]=It,Fd(Ge,$t,xe,me),Nd(Ge,re,Xt),ki(Ge,ai(Rt),ai(It),j,X))}}}if(Ue.show&&cs)if(_!=null){let[lt,dt]=Ye.scales,[Ct,Rt]=Ye.match,[It,$t]=_.cursor.sync.scales,xe=_.cursor.drag;if(cn=xe._x,hn=xe._y,cn||hn){let{left:me,top:re,width:Xt,height:Vt}=_.select,Ne=_.scales[It].ori,Ge=_.posToVal,fn,we,We,Hn,An,ni=lt!=null&&Ct(lt,It),di=dt!=null&&Rt(dt,$t);ni&&cn?(Ne==0?(fn=me,we=Xt):(fn=re,we=Vt),We=y[lt],Hn=F(Ge(fn,It),We,$,0),An=F(Ge(fn+we,It),We,$,0),_o(_i(Hn,An),tn(An-Hn))):_o(0,$),di&&hn?(Ne==1?(fn=me,we=Xt):(fn=re,we=Vt),We=y[dt],Hn=W(Ge(fn,$t),We,st,0),An=W(Ge(fn+we,$t),We,st,0),xo(_i(Hn,An),tn(An-Hn))):xo(0,st)}else yc()}else{let lt=tn(Bf-Ff),dt=tn(zf-kf);if(R.ori==1){let $t=lt;lt=dt,dt=$t}cn=gn.x&&lt>=gn.dist,hn=gn.y&&dt>=gn.dist;let Ct=gn.uni;Ct!=null?cn&&hn&&(cn=lt>=Ct,hn=dt>=Ct,!cn&&!hn&&(dt>lt?hn=!0:cn=!0)):gn.x&&gn.y&&(cn||hn)&&(cn=hn=!0);let Rt,It;cn&&(R.ori==0?(Rt=pr,It=De):(Rt=mr,It=Be),_o(_i(Rt,It),tn(It-Rt)),hn||xo(0,st)),hn&&(R.ori==1?(Rt=pr,It=De):(Rt=mr,It=Be),xo(_i(Rt,It),tn(It-Rt)),cn||_o(0,$)),!cn&&!hn&&(_o(0,0),xo(0,0))}if(gn._x=cn,gn._y=hn,_==null){if(T){if(Qf!=null){let[lt,dt]=Ye.scales;Ye.values[0]=lt!=null?Ui(R.ori==0?De:Be,lt):null,Ye.values[1]=dt!=null?Ui(R.ori==1?De:Be,dt):null}vo(Rc,n,De,Be,j,X,I)}if(Wi){let lt=T&&Ye.setSeries,dt=Vn.prox;Ds==null?Yi<=dt&&Di(us,_r,!0,lt):Yi>dt?Di(null,_r,!0,lt):us!=Ds&&Di(us,_r,!0,lt)}}nt&&(vt.idx=I,gc()),v!==!1&&un("setCursor")}let fs=null;Object.defineProperty(n,"rect",{get(){return fs==null&&yo(!1),fs}});function yo(_=!1){_?fs=null:(fs=g.getBoundingClientRect(),un("syncRect",fs))}function Gf(_,v,T,I,k,$,st){pt._lock||cs&&_!=null&&_.movementX==0&&_.movementY==0||(_c(_,v,T,I,k,$,st,!1,_!=null),_!=null?Us(null,!0,!0):Us(v,!0,!1))}function _c(_,v,T,I,k,$,st,lt,dt){if(fs==null&&yo(!1),je(_),_!=null)T=_.clientX-fs.left,I=_.clientY-fs.top;else{if(T<0||I<0){De=-10,Be=-10;return}let[Ct,Rt]=Ye.scales,It=v.cursor.sync,[$t,xe]=It.values,[me,re]=It.scales,[Xt,Vt]=Ye.match,Ne=v.axes[0].side%2==1,Ge=R.ori==0?j:X,fn=R.ori==1?j:X,we=Ne?$:k,We=Ne?k:$,Hn=Ne?I:T,An=Ne?T:I;if(me!=null?T=Xt(Ct,me)?a($t,y[Ct],Ge,0):-10:T=Ge*(Hn/we),re!=null?I=Vt(Rt,re)?a(xe,y[Rt],fn,0):-10:I=fn*(An/We),R.ori==1){let ni=T;T=I,I=ni}}dt&&(v==null||v.cursor.event.type==Rc)&&((T<=1||T>=j-1)&&(T=Fs(T,j)),(I<=1||I>=X-1)&&(I=Fs(I,X))),lt?(Ff=T,kf=I,[pr,mr]=pt.move(n,T,I)):(De=T,Be=I)}let xc={width:0,height:0,left:0,top:0};function yc(){ua(xc,!1)}let Wf,Xf,qf,Yf;function $f(_,v,T,I,k,$,st){cs=!0,cn=hn=gn._x=gn._y=!1,_c(_,v,T,I,k,$,st,!0,!1),_!=null&&(Pt(Pc,Nc,Zf,!1),vo(Cd,n,pr,mr,j,X,null));let{left:lt,top:dt,width:Ct,height:Rt}=Ue;Wf=lt,Xf=dt,qf=Ct,Yf=Rt}function Zf(_,v,T,I,k,$,st){cs=gn._x=gn._y=!1,_c(_,v,T,I,k,$,st,!1,!0);let{left:lt,top:dt,width:Ct,height:Rt}=Ue,It=Ct>0||Rt>0,$t=Wf!=lt||Xf!=dt||qf!=Ct||Yf!=Rt;if(It&&$t&&ua(Ue),gn.setScale&&It&&$t){let xe=lt,me=Ct,re=dt,Xt=Rt;if(R.ori==1&&(xe=dt,me=Rt,re=lt,Xt=Ct),cn&&hs(C,Ui(xe,C),Ui(xe+me,C)),hn)for(let Vt in y){let Ne=y[Vt];Vt!=C&&Ne.from==null&&Ne.min!=Ce&&hs(Vt,Ui(re+Xt,Vt),Ui(re,Vt))}yc()}else pt.lock&&(pt._lock=!pt._lock,Us(v,!0,_!=null));_!=null&&(P(Pc,Nc),vo(Pc,n,De,Be,j,X,null))}function L0(_,v,T,I,k,$,st){if(pt._lock)return;je(_);let lt=cs;if(cs){let dt=!0,Ct=!0,Rt=10,It,$t;R.ori==0?(It=cn,$t=hn):(It=hn,$t=cn),It&&$t&&(dt=De<=Rt||De>=j-Rt,Ct=Be<=Rt||Be>=X-Rt),It&&dt&&(De=De<pr?0:j),$t&&Ct&&(Be=Be<mr?0:X),Us(null,!0,!0),cs=!1}De=-10,Be=-10,mt.fill(null),Us(null,!0,!0),lt&&(cs=lt)}function Kf(_,v,T,I,k,$,st){pt._lock||(je(_),Lt(),yc(),_!=null&&vo(Id,n,De,Be,j,X,null))}function Jf(){b.forEach(Kx),rt(n.width,n.height,!0)}zs(Ea,Sr,Jf);let xr={};xr.mousedown=$f,xr.mousemove=Gf,xr.mouseup=Zf,xr.dblclick=Kf,xr.setSeries=(_,v,T,I)=>{let k=Ye.match[2];T=k(n,v,T),T!=-1&&Di(T,I,!0,!1)},at&&(Pt(Cd,g,$f),Pt(Rc,g,Gf),Pt(Rd,g,_=>{je(_),yo(!1)}),Pt(Pd,g,L0),Pt(Id,g,Kf),Gc.add(n),n.syncRect=yo);let fa=n.hooks=i.hooks||{};function un(_,v,T){fc?go.push([_,v,T]):_ in fa&&fa[_].forEach(I=>{I.call(null,n,v,T)})}(i.plugins||[]).forEach(_=>{for(let v in _.hooks)fa[v]=(fa[v]||[]).concat(_.hooks[v])});let jf=(_,v,T)=>T,Ye=$e({key:null,setSeries:!1,filters:{pub:Hd,sub:Hd},scales:[C,M[1]?M[1].scale:null],match:[Gd,Gd,jf],values:[null,null]},pt.sync);Ye.match.length==2&&Ye.match.push(jf),pt.sync=Ye;let Qf=Ye.key,vc=Bp(Qf);function vo(_,v,T,I,k,$,st){Ye.filters.pub(_,v,T,I,k,$,st)&&vc.pub(_,v,T,I,k,$,st)}vc.sub(n);function D0(_,v,T,I,k,$,st){Ye.filters.sub(_,v,T,I,k,$,st)&&xr[_](null,v,T,I,k,$,st)}n.pub=D0;function U0(){vc.unsub(n),Gc.delete(n),fe.clear(),kc(Ea,Sr,Jf),c.remove(),ot?.remove(),un("destroy")}n.destroy=U0;function Mc(){un("init",i,t),Ot(t||i.data,!1),J[C]?dc(C,J[C]):Lt(),yt=Ue.show&&(Ue.width>0||Ue.height>0),z=nt=!0,rt(i.width,i.height)}return M.forEach(mo),b.forEach(hc),e?e instanceof HTMLElement?(e.appendChild(c),Mc()):e(n,Mc):Mc(),n}pn.assign=$e;pn.fmtNum=Kc;pn.rangeNum=Aa;pn.rangeLog=Ra;pn.rangeAsinh=$c;pn.orient=Hs;pn.pxRatio=ye;pn.join=V_;pn.fmtDate=jc,pn.tzDate=j_;pn.sync=Bp;{pn.addGap=Ux,pn.clipGaps=La;let i=pn.paths={points:Xp};i.linear=Yp,i.stepped=Fx,i.bars=kx,i.spline=zx}var Do=null;function Jp(){let i=JSON.parse(document.getElementById("data").textContent),t=atob(document.getElementById("blob").textContent);Do=new Uint8Array(t.length);for(let e=0;e<t.length;++e)Do[e]=t.charCodeAt(e);return i}function qe(i){if(i.type==="u32")return new Uint32Array(Do.buffer,i.at,i.n);if(i.type==="f32")return new Float32Array(Do.buffer,i.at,i.n);let t=new Int16Array(Do.buffer,i.at,i.n),e=new Float32Array(i.n);for(let n=0;n<i.n;++n)e[n]=t[n]*i.scale;return e}function li(i,t){return i.map(e=>typeof e=="number"?new Float32Array(t).fill(e):qe(e))}function rh(i,t,e){let n=i.length;if(n===0||e<i[0]||e>i[n-1])return n&&Math.abs(e-i[n-1])<1e-6*Math.abs(e)?t[n-1]:NaN;let s=0,r=n-1;for(;r-s>1;){let a=s+r>>1;i[a]<=e?s=a:r=a}let o=i[r]-i[s];return o>0?t[s]+(e-i[s])/o*(t[r]-t[s]):t[s]}function Oa(i){let t=-1/0;return(e,n)=>{let s=performance.now();n&&s-t<150||(t=s,i(e))}}var gs=class{constructor(t){this.t=t,this.at=t.length?t[0]:0,this.listeners=[]}get first(){return this.t[0]}get last(){return this.t[this.t.length-1]}listen(t){this.listeners.push(t),t(this.at,!1)}set(t,e=!1){this.at=Math.max(this.first,Math.min(this.last,t));for(let n of this.listeners)n(this.at,e)}record(){let{t,at:e}=this,n=0,s=t.length-1;for(;s-n>1;){let o=n+s>>1;t[o]<=e?n=o:s=o}let r=t[s]-t[n];return r>0?n+(e-t[n])/r:n}step(t){let e=Math.max(0,Math.min(this.t.length-1,Math.round(this.record())+t));this.set(this.t[e])}};var Fa=[];ds(()=>Fa.forEach(i=>i.redraw(!1)));var Jx=318;addEventListener("beforeprint",()=>Fa.forEach(i=>i.setSize({width:Jx,height:i.height})));addEventListener("afterprint",()=>Fa.forEach(i=>i.setSize({width:i.root.parentElement.clientWidth,height:i.height})));var lh=190,jp={initial:[5,4],total:[5,4]},ch=(i,t)=>i==="initial"?Pn[1]:i==="final"?Pn[0]:Pn[t%Pn.length],jx=1e-12,oh=8;function hh(i,t){let e=i.filter(c=>c.lines.some(h=>h.x.n>2));if(e.length<=oh)return e.map(c=>ah(c,t));let n=new Map(e.map(c=>[c,c.limit?Ir(qe(c.lines[c.lines.length-1].y))/c.limit:0]));e.sort((c,h)=>n.get(h)-n.get(c));let s=e.slice(0,oh),r=e.slice(oh),o=N("div",{class:"column"}),a=()=>o.childNodes.length||o.append(...r.map(c=>ah(c,t))),l=n.get(e[0])>0?", further from their limits":"";return[...s.map(c=>ah(c,t)),N("details",{class:"card folded",ontoggle:a},N("summary",{},`${r.length} more charts${l}`),o)]}function ah(i,t){let e=i.lines.map(b=>({label:b.label,x:qe(b.x),y:qe(b.y)})),n=e.filter(b=>Ir(b.y)>0),s=n.length?n:e,r=e.filter(b=>!s.includes(b)).map(b=>b.label),o=i.limit??0;for(let b of s)for(let y of b.y)o=Math.max(o,Math.abs(y));let a=Fi(o,i.unit),l=a.unit&&a.unit!=="-"?`\xA0${a.unit}`:"",c=N("div",{class:"legend"}),h=N("div",{class:"plot"});h.style.minHeight=`${i.height??lh}px`;let u=s.map(b=>Ir(b.y)/i.limit-1),f=N("h2",{},i.title,N("span",{class:"unit"},a.unit?` [${a.unit}]`:"")),p=N("section",{class:"card chart","data-chart":i.title},f,c,h),g=s.map((b,y)=>{let U=N("b",{}),C=i.limit?N("i",{class:u[y]>.001?"bad":""},` peak ${Rn(u[y])}`):null;return c.append(N("span",{},Lr(ch(b.label,y),!!jp[b.label]),b.label," ",U,C)),U});i.limit&&c.append(N("span",{},Lr("var(--bad)",!0),"limit ",N("b",{},Fn(i.limit/a.factor)+l))),i.error&&c.append(N("span",{class:"error"},"error of the peak by mesh and step \xB1 ",N("b",{},zt(i.error,i.unit,2)))),r.length&&c.append(N("span",{class:"still"},`${r.join(", ")}: 0 throughout`));let x=tm(h,s,i,a),m=s.map(b=>jx*Ir(b.y)),d=(b,y)=>Math.abs(b)<m[y]?0:b,M=b=>s.forEach((y,U)=>g[U].textContent=ze(d(rh(y.x,y.y,b),U)/a.factor,4)+l);return em(x,t??new gs(s[0].x),M,{name:i.title,peak:()=>Qp(s),words:()=>c.textContent}),p}function Ir(i){let t=0;for(let e of i)Number.isFinite(e)&&(t=Math.max(t,Math.abs(e)));return t}function Qp(i){let{x:t,y:e}=i[i.length-1],n=Ir(e);return t[Math.max(0,e.findIndex(s=>Math.abs(s)===n))]}function Lr(i,t=!1){let e=N("span",{class:t?"swatch dashed":"swatch"});return e.style.background=t?"none":i,t&&(e.style.borderColor=i),e}function Qx(i){let t={stroke:()=>dn("soft"),font:"11px system-ui, sans-serif",ticks:{show:!1},grid:{stroke:()=>dn("line"),width:1}},e=i.abscissa_unit&&i.abscissa_unit!=="-"?`${i.abscissa} [${i.abscissa_unit}]`:i.abscissa;return[{...t,size:22,incrs:i.points?[1,2,5,10,20,50,100]:void 0,label:e.replace("_"," "),labelSize:15,labelFont:"11px system-ui, sans-serif",labelGap:-2,values:(n,s)=>Uo(s)},{...t,size:48,values:(n,s)=>Uo(s)}]}function Uo(i){let t=Math.min(...i.slice(1).map((e,n)=>e-i[n]));for(let e=3;e<8;++e){let n=i.map(s=>Fn(s,e));if(i.every(s=>Math.abs(Number(s.toPrecision(e))-s)<.05*t))return n}return i.map(e=>Fn(e,8))}function tm(i,t,e,n){let s=t.map(a=>[a.x,Array.from(a.y,l=>Number.isFinite(l)?l/n.factor:null)]),r=s.length>1?pn.join(s.map(a=>a.map(l=>Array.from(l)))):s[0],o=new pn({width:400,height:e.height??lh,padding:[8,16,0,0],legend:{show:!1},cursor:{points:{size:6},drag:{x:!0,y:!1},y:!1},scales:{x:{time:!1},y:{range:(a,l,c)=>ey(l,c,e.limit?e.limit/n.factor:null)}},axes:Qx(e),series:[{},...t.map((a,l)=>({stroke:ch(a.label,l),width:1.6,spanGaps:!0,dash:jp[a.label],points:{show:!!e.points,size:6}}))],hooks:{draw:[a=>{t.forEach((l,c)=>ny(a,s[c],l.label==="initial"?0:(e.error??0)/n.factor,ch(l.label,c))),iy(a,e.limit?e.limit/n.factor:null)}]}},r,i);return new ResizeObserver(()=>{i.clientWidth&&o.setSize({width:i.clientWidth,height:e.height??lh})}).observe(i),Fa.push(o),o}var ty=1e-5;function ey(i,t,e){if(i===null||t===null)return[0,1];let n=e?Math.max(t,1.08*e):t,s=Math.max(Math.abs(i),Math.abs(n)),o=.06*((n-i>ty*s?n-i:s)||1);return[i>=0&&i<.3*n?0:i-o,n+o]}function ny(i,[t,e],n,s){if(!(n>0))return;let{ctx:r,bbox:o}=i,a=t.length;r.save(),r.beginPath(),r.rect(o.left,o.top,o.width,o.height),r.clip(),r.beginPath();for(let l=0;l<2*a;++l){let c=l<a,h=c?l:2*a-1-l;r.lineTo(i.valToPos(t[h],"x",!0),i.valToPos(e[h]+(c?n:-n),"y",!0))}r.globalAlpha=.22,r.fillStyle=s,r.fill(),r.restore()}function iy(i,t){if(!t)return;let{ctx:e,bbox:n}=i,s=i.valToPos(t,"y",!0);e.save(),e.fillStyle=pa()?"rgba(255,90,80,.10)":"rgba(200,40,30,.07)",e.fillRect(n.left,n.top,n.width,Math.max(0,s-n.top)),e.strokeStyle=dn("bad"),e.setLineDash([6,4]),e.beginPath(),e.moveTo(n.left,s),e.lineTo(n.left+n.width,s),e.stroke(),e.restore()}function em(i,t,e,n){let s=N("div",{class:"now"}),{over:r}=i;r.append(s);let o=c=>{let h=i.valToPos(c,"x");s.style.transform=`translateX(${h.toFixed(1)}px)`,s.hidden=!(h>=0&&h<=r.clientWidth)},a=()=>{r.setAttribute("aria-valuenow",t.at),r.setAttribute("aria-valuetext",n.words())};for(let[c,h]of Object.entries({tabindex:0,role:"slider","aria-label":n.name,"aria-valuemin":t.first,"aria-valuemax":t.last}))r.setAttribute(c,h);t.listen(o),t.listen(Oa(c=>{e(c),document.activeElement===r&&a()})),a(),i.hooks.setSize=[()=>o(t.at)],i.hooks.setScale=[()=>o(t.at)];let l=0;r.addEventListener("mousedown",c=>l=c.clientX),r.addEventListener("click",c=>{Math.abs(c.clientX-l)>3||t.set(i.posToVal(c.clientX-r.getBoundingClientRect().left,"x"))}),r.addEventListener("focus",a),r.addEventListener("keydown",c=>sy(c,t,n.peak))}function sy(i,t,e){if(i.ctrlKey||i.metaKey||i.altKey)return;let n=Math.max(1,Math.round(t.t.length/10)),s={ArrowLeft:()=>t.step(-1),ArrowRight:()=>t.step(1),PageDown:()=>t.step(-n),PageUp:()=>t.step(n),Home:()=>t.set(t.first),End:()=>t.set(t.last),p:()=>t.set(e())}[i.key.length===1?i.key.toLowerCase():i.key];s&&(s(),i.preventDefault(),i.stopPropagation())}function No(i,t,e,n,s){let r={title:i,unit:t,abscissa:s.word,abscissa_unit:"",height:130,points:!0},o=Fi(Ir(n),t),a=N("div",{class:"plot"}),l={label:"final",x:Float64Array.from(e),y:Float64Array.from(n)},c=tm(a,[l],r,o);return em(c,s,()=>{},{name:i,peak:()=>Qp([l]),words:()=>`${s.word} ${s.at}: ${ze(rh(l.x,l.y,s.at)/o.factor,4)} ${o.unit}`}),N("div",{class:"chart"},N("h3",{},i,N("span",{class:"unit"},o.unit?` [${o.unit}]`:"")),a)}var ry=660,oy=5.6,ay=9,ly=46,cy=/([_/\\,=]|\.(?=[a-z_]))(?=.)/gi,ka=i=>String(i).replace(cy,"$1\u200B"),hy=i=>Math.max(...ka(i).split(/[\s\u200b]/).map(t=>t.length));function nm(i,t,e,n){let[s,...r]=i;if(!s)return[];let o=p=>t.length>1&&t.every(g=>p.cells[g]===p.cells[t[0]]),a=r.filter(o),l=r.filter(p=>!a.includes(p)),c=p=>ay+oy*Math.max(hy(e(p)),Math.min(ly,Math.max(...t.map(g=>String(n(p,g)).length)))),h=[[s]],u=c(s);for(let p of l)u+c(p)>ry&&h[h.length-1].length>1&&(h.push([s]),u=c(s)),h[h.length-1].push(p),u+=c(p);let f=a.map(p=>`${e(p)} ${n(p,t[0])}`).join(" \xB7 ");return[f?N("p",{class:"note"},`The same in all rows: ${ka(f)}`):null,...h.map(p=>uy(p,t,e,n))].filter(Boolean)}function uy(i,t,e,n){let s=o=>o.number?"n":"text",r=i.length<4&&i.every(o=>o.number);return N("table",{class:r&&"narrow"},N("thead",{},N("tr",{},i.map(o=>N("th",{class:s(o)},ka(e(o)))))),N("tbody",{},t.map(o=>N("tr",{},i.map(a=>N("td",{class:s(a)},a.number?n(a,o):ka(n(a,o))))))))}var Ba=68,za=40,uh=12,fh=14,fy=9,Oo=class{constructor({describe:t,open:e}){Object.assign(this,{describe:t,open:e,points:[],hovered:null}),this.canvas=N("canvas",{class:"scatter",tabindex:0,role:"img","aria-label":"points; arrows go from one to the next, Enter opens it"}),this.tip=N("div",{class:"tip",hidden:!0,"aria-live":"polite"}),this.node=N("div",{class:"plot scatterbox"},this.canvas,this.tip),this.canvas.addEventListener("mousemove",n=>this.hover(n)),this.canvas.addEventListener("mouseleave",()=>this.hover(null)),this.canvas.addEventListener("click",()=>this.hovered&&this.open?.(this.hovered.row)),this.canvas.addEventListener("keydown",n=>this.byKey(n)),this.canvas.addEventListener("blur",()=>this.point(null)),new ResizeObserver(()=>this.draw()).observe(this.node),ds(()=>this.draw()),addEventListener("beforeprint",()=>this.draw())}set(t,e){this.o=e,this.points=t.filter(n=>Number.isFinite(n.x)&&Number.isFinite(n.y)&&(!e.logx||n.x>0)&&(!e.logy||n.y>0)),this.hovered=null,this.tip.hidden=!0,this.draw()}draw(){let{canvas:t,node:e,o:n}=this;if(!n||!e.clientWidth)return;let s=devicePixelRatio||1,r=e.clientWidth,o=340;t.width=r*s,t.height=o*s,t.style.width=`${r}px`,t.style.height=`${o}px`;let a=this.ctx=t.getContext("2d");a.scale(s,s),a.font="11px system-ui, sans-serif",this.ax=im(this.points.map(l=>l.x),n.logx,Ba,r-fh),this.ay=im(this.points.map(l=>l.y),n.logy,o-za,uh),this.drawAxes(a,r,o),n.lines&&this.drawLines(a);for(let l of this.points)this.drawPoint(a,l,l===this.hovered?7:4.5)}drawAxes(t,e,n){let{ax:s,ay:r,o}=this;t.strokeStyle=dn("line"),t.fillStyle=dn("soft"),t.textAlign="center",t.beginPath();let a=-1/0,l=Uo(s.ticks),c=Uo(r.ticks);for(let[h,u]of s.ticks.entries()){t.moveTo(s.at(u),uh),t.lineTo(s.at(u),n-za);let f=.5*t.measureText(l[h]).width;s.at(u)-f<a||(t.fillText(l[h],Math.min(s.at(u),e-f-1),n-za+15),a=s.at(u)+f+8)}t.textAlign="right";for(let[h,u]of r.ticks.entries())t.moveTo(Ba,r.at(u)),t.lineTo(e-fh,r.at(u)),t.fillText(c[h],Ba-7,r.at(u)+4);t.stroke(),t.textAlign="center",t.fillText(o.xlabel,(Ba+e-fh)/2,n-6),t.save(),t.translate(12,(n-za+uh)/2),t.rotate(-Math.PI/2),t.fillText(o.ylabel,0,0),t.restore()}colour(t){let{o:e}=this;return e.shade?va("size",t.shade??0):Pn[Math.max(0,(e.groups??[]).indexOf(t.group))%Pn.length]}drawPoint(t,e,n){t.beginPath(),t.arc(this.ax.at(e.x),this.ay.at(e.y),n,0,2*Math.PI),t.fillStyle=e.hollow?dn("card"):this.colour(e),t.globalAlpha=e===this.hovered?1:.82,t.fill(),t.globalAlpha=1,t.strokeStyle=e.hollow?this.colour(e):dn("card"),t.stroke()}drawLines(t){for(let e of this.o.groups){let n=this.points.filter(r=>r.group===e&&!r.hollow).sort((r,o)=>r.x-o.x||r.y-o.y),s=[];for(let r of n)(!s.length||r.y<s[s.length-1].y)&&s.push(r);if(!(s.length<2)){t.beginPath();for(let r of s)t.lineTo(this.ax.at(r.x),this.ay.at(r.y));t.strokeStyle=this.colour(s[0]),t.globalAlpha=.5,t.lineWidth=1.5,t.stroke(),t.lineWidth=1,t.globalAlpha=1}}}hover(t){let e=null,n=fy;if(t&&this.ax)for(let s of this.points){let r=Math.hypot(this.ax.at(s.x)-t.offsetX,this.ay.at(s.y)-t.offsetY);r<n&&([e,n]=[s,r])}this.point(e,t??{})}point(t,{offsetX:e=t&&this.ax.at(t.x),offsetY:n=t&&this.ay.at(t.y)}={}){if(t!==this.hovered&&(this.hovered=t,this.draw()),this.tip.hidden=!t,this.canvas.style.cursor=t&&this.open?"pointer":"default",!t)return;this.tip.replaceChildren(...this.describe(t.row).map((r,o)=>N(o?"div":"b",{},r)));let s=e>this.node.clientWidth/2;this.tip.style.left=s?"auto":`${e+14}px`,this.tip.style.right=s?`${this.node.clientWidth-e+14}px`:"auto",this.tip.style.top=`${Math.min(n,200)}px`}byKey(t){if(t.ctrlKey||t.metaKey||t.altKey||!this.points.length)return;let{hovered:e}=this,n=(o,a)=>[...this.points].sort((l,c)=>l[o]-c[o]||l[a]-c[a]),s=(o,a)=>e?o[Math.max(0,Math.min(o.length-1,o.indexOf(e)+a))]:o[0],r={ArrowLeft:()=>this.point(s(n("x","y"),-1)),ArrowRight:()=>this.point(s(n("x","y"),1)),ArrowDown:()=>this.point(s(n("y","x"),-1)),ArrowUp:()=>this.point(s(n("y","x"),1)),Home:()=>this.point(n("x","y")[0]),End:()=>this.point(n("x","y")[this.points.length-1]),Enter:()=>e&&this.open?.(e.row),Escape:()=>this.point(null)}[t.key];r&&(r(),t.preventDefault(),t.stopPropagation())}};function im(i,t,e,n){let s=Math.min(...i),r=Math.max(...i);if(i.length||([s,r]=[t?1:0,t?10:1]),t){let c=Math.log10(s),h=Math.log10(r),u=.06*(h-c||1),f=[],p=h-c>2.2?[1]:h-c>.8?[1,2,5]:[1,1.5,2,3,4,5,6,7,8,9];for(let g=Math.floor(c-u);g<=Math.ceil(h+u);++g)for(let x of p)Math.log10(x)+g>=c-u&&Math.log10(x)+g<=h+u&&f.push(x*10**g);return{ticks:f,at:g=>e+(Math.log10(g)-c+u)/(h-c+2*u)*(n-e)}}let o=.06*(r-s||Math.abs(r)||1),a=s-o,l=r+o;return{ticks:dh(a,l),at:c=>e+(c-a)/(l-a)*(n-e)}}function dh(i,t){let e=(t-i)/6||1,n=10**Math.floor(Math.log10(e)),s=[1,2,5,10].map(o=>o*n).find(o=>o>=e),r=[];for(let o=Math.ceil(i/s-1e-9);o*s<=t+1e-9*s;++o)r.push(o*s);return r}var Va=400;function sm(i){let t=i.cases.columns,e=i.summary.command==="compare",n=new gh(t,i,e);return[e?_y(n):py(n),n.card()]}var gh=class{constructor(t,e,n){let s=e.summary.input_units??{},r=t.filter((o,a)=>a===0||o.cells.some(l=>l!==null&&l!=="")).map(o=>({...o,unit:od(o.unit||s[o.name])})).map(o=>({...o,...bd(o)}));Object.assign(this,{columns:r,data:e,compare:n,sorted:null,down:!1,listeners:[]}),this.certified=r.some(o=>o.name.startsWith("kkt")),this.count=r.length?r[0].cells.length:0,this.rows=[...Array(this.count).keys()]}column(t){return this.columns.find(e=>e.name===t)}numeric(){return this.columns.filter(t=>t.number)}heading(t){return t.shown?`${t.title} [${t.shown}]`:t.title}value(t,e){return(t.cells[e]??NaN)/t.factor}cell(t,e){let n=t.cells[e];return n===null||n===""?"\u2013":t.number?t.unit?ze(n/t.factor,4):Fn(n/t.factor,4):n}card(){this.filter=N("input",{type:"search",id:"filter",placeholder:"filter: text, or column > value; another",oninput:()=>this.update()}),this.head=N("tr",{},this.columns.map(n=>N("th",{class:n.number?"n":"",tabindex:0,title:`sort by ${n.name}${n.unit?`, ${n.unit}`:""}`,onclick:()=>this.sort(n),onkeydown:s=>s.key==="Enter"&&this.sort(n)},this.heading(n)))),this.body=N("tbody",{}),this.note=N("p",{class:"note","aria-live":"polite"}),this.said=N("div",{id:"said","aria-live":"polite"});let t=N("div",{class:"printed paper"});addEventListener("beforeprint",()=>t.replaceChildren(...nm(this.columns,this.rows.slice(0,Va),n=>this.heading(n),(n,s)=>this.cell(n,s)))),addEventListener("afterprint",()=>t.replaceChildren());let e=Xe(this.compare?"Rows":"Cases",N("div",{class:"controls two"},this.filter,this.note),this.said,t,N("div",{class:"scroll tall"},N("table",{id:"cases"},N("thead",{},this.head),this.body)));return this.update(),e}sort(t){this.down=this.sorted===t?!this.down:!1,this.sorted=t,this.update()}terms(){return this.filter.value.split(/\s*;\s*|\s+and\s+/).filter(Boolean).map(t=>{let[,e,n,s]=t.match(/^(.*?)\s*(<=|>=|<|>|=)\s*(\S.*)$/)??[],r=e?.trim();return{text:t.toLowerCase().trim(),key:r,sign:n,value:s,column:r?this.column(r)??this.columns.find(o=>o.title===r)??null:null}})}matches(t,e){return e.every(({text:n,key:s,sign:r,value:o,column:a})=>{if(!a)return this.columns.some(h=>String(h.cells[t]??"").toLowerCase().includes(n));let l=a.cells[t],c=a.number?Number(o)*(a.name===s?1:a.factor):o;return l===null?!1:{"<":l<c,">":l>c,"<=":l<=c,">=":l>=c,"=":l===c}[r]})}update(){let t=this.terms();if(this.rows=[...Array(this.count).keys()].filter(n=>this.matches(n,t)),this.sorted){let n=s=>this.sorted.cells[s]??(this.sorted.number?1/0:"");this.rows.sort((s,r)=>(n(s)<n(r)?-1:n(s)>n(r)?1:0)*(this.down?-1:1))}[...this.head.children].forEach((n,s)=>n.setAttribute("aria-sort",this.columns[s]===this.sorted?this.down?"descending":"ascending":"none")),this.body.replaceChildren(...this.rows.slice(0,Va).map(n=>this.line(n)));let e=this.rows.length>Va?`, the first ${Va} shown`:this.rows.length?"":dy(t);this.note.textContent=this.count?`${this.rows.length} of ${this.count}${e}`:`no ${this.compare?"row":"case"} has ended yet`;for(let n of this.listeners)n()}line(t){let e=this.address(t);return N("tr",{class:e||!this.compare?"opens":"",onclick:()=>this.open(t)},this.columns.map((n,s)=>{let r=this.cell(n,t),o=n.name==="status"?Ac(r,this.certified):s===0&&e?N("a",{href:e},r):r;return N("td",{class:n.number?"n":"text",title:n.number?null:r},o)}))}address(t){let e=String(this.columns[0].cells[t]);return this.data.reported?.includes(e)?`cases/${encodeURIComponent(e)}/report.html`:null}open(t){let e=this.address(t);if(e&&(location.href=e),e||this.compare||!this.said)return;let[n,...s]=this.columns,r=String(n.cells[t]);this.said.replaceChildren(N("h3",{},`Case ${r}`),N("dl",{class:"figures"},s.filter(o=>o.cells[t]!==null&&o.cells[t]!=="").flatMap(o=>[N("dt",{},o.title),N("dd",{},this.told(o,t))])),N("p",{class:"note"},`It has no page yet: "liesl report ${this.data.folder}/cases/${r}" writes it, "liesl report ${this.data.folder}" then links it here.`)),this.said.scrollIntoView({block:"nearest"})}told(t,e){return t.shown&&t.cells[e]!==null?`${this.cell(t,e)} ${t.shown}`:this.cell(t,e)}describe(t,e){let n=this.columns[0];return[`${n.name} ${n.cells[t]}`,...this.columns.filter(s=>e.includes(s.name)).map(s=>`${s.title}: ${this.told(s,t)}`)]}},ph=(i,t,e,n)=>N("select",{id:i,onchange:n},t.map(r=>N("option",{value:r.name,selected:r.name===e},r.title)));function dy(i){let t=i.find(n=>n.key&&!n.column),e=i.find(({column:n,value:s})=>n?.number&&Number.isNaN(Number(s)));return t?`; there is no column '${t.key}'`:e?`; '${e.value}' is no number: "speed > 130; cycles > 3" joins two conditions`:""}var mh=(i,t)=>N("span",{class:"named"},N("label",{for:t.id},i)," ",t);function py(i){if(!i.count)return null;let t=i.numeric().filter(x=>x!==i.columns[0]);if(t.length<2)return Xe("",N("p",{class:"note"},"No two columns of numbers to compare."));let e=t.filter(x=>new Set(x.cells).size>1),n=e[0]??t[0],s=i.column("mass_final")??e[e.length-1]??t[1],r=e.find(x=>x!==n&&x!==s)??n,o=new Oo({describe:x=>i.describe(x,[h.value,u.value,f.value,"status",...i.columns.slice(1,5).map(m=>m.name)]),open:x=>i.open(x)}),a=i.column("status"),l=x=>Boolean(a)&&!fd(a.cells[x]),c=()=>{let x=i.column(h.value),m=i.column(u.value),d=i.column(f.value),M=d.cells.filter(U=>U!==null),b=Math.min(...M),y=Math.max(...M);p.replaceChildren(my(d,b,y)),o.set(i.rows.map(U=>({x:i.value(x,U),y:i.value(m,U),row:U,shade:(d.cells[U]-b)/(y-b||1),hollow:l(U)})),{xlabel:i.heading(x),ylabel:i.heading(m),shade:!0})},h=ph("scatter-x",t,n.name,c),u=ph("scatter-y",t,s.name,c),f=ph("scatter-c",t,r.name,c),p=N("span",{class:"colours inline"});return i.listeners.push(c),Xe("Any two columns",N("div",{class:"controls row"},mh("across",h),mh("upwards",u),mh("colour",f),p),o.node,i.rows.some(l)?N("p",{class:"note"},"Hollow: cases that did not end as they should, as their status says."):null)}function my(i,t,e){let n=N("span",{class:"strip viridis"});return N("span",{},Fn(t/i.factor,3)," ",n," ",Fn(e/i.factor,3),i.shown?` ${i.shown}`:"")}var gy=new Set(["run","error","cpu_s","cpu_spread","steps","newton_iterations","tangent_refreshes","rejected_steps","factorizations","energy_drift","momentum_drift","angular_momentum_drift","constraint_residual","floor","reason","simulations","sensitivities","mass","violation","kkt"]);function _y(i){let t=i.column("error"),e=i.column("cpu_s"),n=t??i.column(i.data.summary.response)??i.column("mass")??i.column("mass_final");if(!n?.number||!e?.number)return null;let s=i.columns.filter(f=>!gy.has(f.name)&&f!==n),r=i.column("formalism")??i.column("method")??s.find(f=>!f.number&&new Set(f.cells).size>1)??i.columns[1],o=[...new Set(r.cells.map(String))],a=new Oo({describe:f=>i.describe(f,[...s.map(p=>p.name),n.name,"cpu_s","steps","violation","kkt"])}),l=f=>i.column("violation")?.cells[f]>.001;i.listeners.push(()=>a.set(i.rows.map(f=>({x:i.value(e,f),y:i.value(n,f),row:f,group:String(r.cells[f]),hollow:l(f)})),{xlabel:i.heading(e),ylabel:i.heading(n),logx:!0,logy:n===t,groups:o,lines:!0}));let c=N("div",{class:"legend"},o.map((f,p)=>N("span",{},Lr(Pn[p%Pn.length]),f))),h=n.title.replace("_"," ");return Xe(`${h[0].toUpperCase()}${h.slice(1)} against time`,c,a.node,N("p",{class:"note"},"Each point is a row of the table; lines join those that no other of the same kind beats in both.",i.rows.some(l)?" Hollow: limits are not met.":""))}var lf="170",rr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},or={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},xy=0,rm=1,yy=2;var cg=1,vy=2,es=3,As=0,kn=1,bi=2,ws=0,Zr=1,om=2,am=3,lm=4,My=5,Ks=100,by=101,Sy=102,wy=103,Ey=104,Ay=200,Ty=201,Cy=202,Ry=203,qh=204,Yh=205,Py=206,Iy=207,Ly=208,Dy=209,Uy=210,Ny=211,Oy=212,Fy=213,ky=214,$h=0,Zh=1,Kh=2,Qr=3,Jh=4,jh=5,Qh=6,tu=7,hg=0,By=1,zy=2,Es=0,Vy=1,Hy=2,Gy=3,Wy=4,Xy=5,qy=6,Yy=7;var ug=300,to=301,eo=302,eu=303,nu=304,kl=306,iu=1e3,js=1001,su=1002,wi=1003,$y=1004;var Ha=1005;var zi=1006,_h=1007;var Qs=1008;var rs=1009,fg=1010,dg=1011,Yo=1012,cf=1013,tr=1014,ns=1015,jo=1016,hf=1017,uf=1018,no=1020,pg=35902,mg=1021,gg=1022,Si=1023,_g=1024,xg=1025,Kr=1026,io=1027,yg=1028,ff=1029,vg=1030,df=1031;var pf=1033,fl=33776,dl=33777,pl=33778,ml=33779,ru=35840,ou=35841,au=35842,lu=35843,cu=36196,hu=37492,uu=37496,fu=37808,du=37809,pu=37810,mu=37811,gu=37812,_u=37813,xu=37814,yu=37815,vu=37816,Mu=37817,bu=37818,Su=37819,wu=37820,Eu=37821,gl=36492,Au=36494,Tu=36495,Mg=36283,Cu=36284,Ru=36285,Pu=36286;var _l=2300,Iu=2301,xh=2302,cm=2400,hm=2401,um=2402;var Zy=3200,Ky=3201;var Jy=0,jy=1,Ss="",hi="srgb",co="srgb-linear",Bl="linear",Ee="srgb";var Dr=7680;var fm=519,Qy=512,tv=513,ev=514,bg=515,nv=516,iv=517,sv=518,rv=519,dm=35044;var $o="300 es",is=2e3,xl=2001,os=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;let n=this._listeners;return n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;let s=this._listeners[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){if(this._listeners===void 0)return;let n=this._listeners[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],pm=1234567,Wo=Math.PI/180,Zo=180/Math.PI;function ho(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(vn[i&255]+vn[i>>8&255]+vn[i>>16&255]+vn[i>>24&255]+"-"+vn[t&255]+vn[t>>8&255]+"-"+vn[t>>16&15|64]+vn[t>>24&255]+"-"+vn[e&63|128]+vn[e>>8&255]+"-"+vn[e>>16&255]+vn[e>>24&255]+vn[n&255]+vn[n>>8&255]+vn[n>>16&255]+vn[n>>24&255]).toLowerCase()}function bn(i,t,e){return Math.max(t,Math.min(e,i))}function mf(i,t){return(i%t+t)%t}function ov(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function av(i,t,e){return i!==t?(e-i)/(t-i):0}function Xo(i,t,e){return(1-e)*i+e*t}function lv(i,t,e,n){return Xo(i,t,1-Math.exp(-e*n))}function cv(i,t=1){return t-Math.abs(mf(i,t*2)-t)}function hv(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function uv(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function fv(i,t){return i+Math.floor(Math.random()*(t-i+1))}function dv(i,t){return i+Math.random()*(t-i)}function pv(i){return i*(.5-Math.random())}function mv(i){i!==void 0&&(pm=i);let t=pm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function gv(i){return i*Wo}function _v(i){return i*Zo}function xv(i){return(i&i-1)===0&&i!==0}function yv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function vv(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Mv(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),f=o((t-n)/2),p=r((n-t)/2),g=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*f,a*c);break;case"YZY":i.set(l*f,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*f,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*p,a*c);break;case"YXY":i.set(l*p,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*p,a*h,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Yr(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Ln(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Sg={DEG2RAD:Wo,RAD2DEG:Zo,generateUUID:ho,clamp:bn,euclideanModulo:mf,mapLinear:ov,inverseLerp:av,lerp:Xo,damp:lv,pingpong:cv,smoothstep:hv,smootherstep:uv,randInt:fv,randFloat:dv,randFloatSpread:pv,seededRandom:mv,degToRad:gv,radToDeg:_v,isPowerOfTwo:xv,ceilPowerOfTwo:yv,floorPowerOfTwo:vv,setQuaternionFromProperEuler:Mv,normalize:Ln,denormalize:Yr},Qt=class{constructor(t=0,e=0){Qt.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(bn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},jt=class{constructor(t,e,n,s,r,o,a,l,c){jt.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],p=n[5],g=n[8],x=s[0],m=s[3],d=s[6],M=s[1],b=s[4],y=s[7],U=s[2],C=s[5],D=s[8];return r[0]=o*x+a*M+l*U,r[3]=o*m+a*b+l*C,r[6]=o*d+a*y+l*D,r[1]=c*x+h*M+u*U,r[4]=c*m+h*b+u*C,r[7]=c*d+h*y+u*D,r[2]=f*x+p*M+g*U,r[5]=f*m+p*b+g*C,r[8]=f*d+p*y+g*D,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,p=c*r-o*l,g=e*u+n*f+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return t[0]=u*x,t[1]=(s*c-h*n)*x,t[2]=(a*n-s*o)*x,t[3]=f*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=p*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(yh.makeScale(t,e)),this}rotate(t){return this.premultiply(yh.makeRotation(-t)),this}translate(t,e){return this.premultiply(yh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},yh=new jt;function wg(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function yl(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function bv(){let i=yl("canvas");return i.style.display="block",i}var mm={};function Ho(i){i in mm||(mm[i]=!0,console.warn(i))}function Sv(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}function wv(i){let t=i.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function Ev(i){let t=i.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}var le={enabled:!0,workingColorSpace:co,spaces:{},convert:function(i,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Ee&&(i.r=ss(i.r),i.g=ss(i.g),i.b=ss(i.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(i.applyMatrix3(this.spaces[t].toXYZ),i.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Ee&&(i.r=Jr(i.r),i.g=Jr(i.g),i.b=Jr(i.b))),i},fromWorkingColorSpace:function(i,t){return this.convert(i,this.workingColorSpace,t)},toWorkingColorSpace:function(i,t){return this.convert(i,t,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===Ss?Bl:this.spaces[i].transfer},getLuminanceCoefficients:function(i,t=this.workingColorSpace){return i.fromArray(this.spaces[t].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,t,e){return i.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function ss(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Jr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var gm=[.64,.33,.3,.6,.15,.06],_m=[.2126,.7152,.0722],xm=[.3127,.329],ym=new jt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),vm=new jt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);le.define({[co]:{primaries:gm,whitePoint:xm,transfer:Bl,toXYZ:ym,fromXYZ:vm,luminanceCoefficients:_m,workingColorSpaceConfig:{unpackColorSpace:hi},outputColorSpaceConfig:{drawingBufferColorSpace:hi}},[hi]:{primaries:gm,whitePoint:xm,transfer:Ee,toXYZ:ym,fromXYZ:vm,luminanceCoefficients:_m,outputColorSpaceConfig:{drawingBufferColorSpace:hi}}});var Ur,Lu=class{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{Ur===void 0&&(Ur=yl("canvas")),Ur.width=t.width,Ur.height=t.height;let n=Ur.getContext("2d");t instanceof ImageData?n.putImageData(t,0,0):n.drawImage(t,0,0,t.width,t.height),e=Ur}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=yl("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ss(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(ss(e[n]/255)*255):e[n]=ss(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Av=0,vl=class{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Av++}),this.uuid=ho(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(vh(s[o].image)):r.push(vh(s[o]))}else r=vh(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function vh(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Lu.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var Tv=0,Sn=class extends os{constructor(t=Sn.DEFAULT_IMAGE,e=Sn.DEFAULT_MAPPING,n=js,s=js,r=zi,o=Qs,a=Si,l=rs,c=Sn.DEFAULT_ANISOTROPY,h=Ss){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Tv++}),this.uuid=ho(),this.name="",this.source=new vl(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Qt(0,0),this.repeat=new Qt(1,1),this.center=new Qt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new jt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==ug)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case iu:t.x=t.x-Math.floor(t.x);break;case js:t.x=t.x<0?0:1;break;case su:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case iu:t.y=t.y-Math.floor(t.y);break;case js:t.y=t.y<0?0:1;break;case su:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Sn.DEFAULT_IMAGE=null;Sn.DEFAULT_MAPPING=ug;Sn.DEFAULT_ANISOTROPY=1;var Ve=class{constructor(t=0,e=0,n=0,s=1){Ve.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],p=l[5],g=l[9],x=l[2],m=l[6],d=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-x)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+x)<.1&&Math.abs(g+m)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let b=(c+1)/2,y=(p+1)/2,U=(d+1)/2,C=(h+f)/4,D=(u+x)/4,O=(g+m)/4;return b>y&&b>U?b<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(b),s=C/n,r=D/n):y>U?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=C/s,r=O/s):U<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(U),n=D/r,s=O/r),this.set(n,s,r,e),this}let M=Math.sqrt((m-g)*(m-g)+(u-x)*(u-x)+(f-h)*(f-h));return Math.abs(M)<.001&&(M=1),this.x=(m-g)/M,this.y=(u-x)/M,this.z=(f-h)/M,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Du=class extends os{constructor(t=1,e=1,n={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new Ve(0,0,t,e),this.scissorTest=!1,this.viewport=new Ve(0,0,t,e);let s={width:t,height:e,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:zi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);let r=new Sn(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);r.flipY=!1,r.generateMipmaps=n.generateMipmaps,r.internalFormat=n.internalFormat,this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let n=0,s=t.textures.length;n<s;n++)this.textures[n]=t.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;let e=Object.assign({},t.texture.image);return this.texture.source=new vl(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},as=class extends Du{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},Ml=class extends Sn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=wi,this.minFilter=wi,this.wrapR=js,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Uu=class extends Sn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=wi,this.minFilter=wi,this.wrapR=js,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Pe=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],f=r[o+0],p=r[o+1],g=r[o+2],x=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u;return}if(a===1){t[e+0]=f,t[e+1]=p,t[e+2]=g,t[e+3]=x;return}if(u!==x||l!==f||c!==p||h!==g){let m=1-a,d=l*f+c*p+h*g+u*x,M=d>=0?1:-1,b=1-d*d;if(b>Number.EPSILON){let U=Math.sqrt(b),C=Math.atan2(U,d*M);m=Math.sin(m*C)/U,a=Math.sin(a*C)/U}let y=a*M;if(l=l*m+f*y,c=c*m+p*y,h=h*m+g*y,u=u*m+x*y,m===1-a){let U=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=U,c*=U,h*=U,u*=U}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],f=r[o+1],p=r[o+2],g=r[o+3];return t[e]=a*g+h*u+l*p-c*f,t[e+1]=l*g+h*f+c*u-a*p,t[e+2]=c*g+h*p+a*f-l*u,t[e+3]=h*g-a*u-l*f-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),f=l(n/2),p=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*p*g,this._y=c*p*u-f*h*g,this._z=c*h*g+f*p*u,this._w=c*h*u-f*p*g;break;case"YXZ":this._x=f*h*u+c*p*g,this._y=c*p*u-f*h*g,this._z=c*h*g-f*p*u,this._w=c*h*u+f*p*g;break;case"ZXY":this._x=f*h*u-c*p*g,this._y=c*p*u+f*h*g,this._z=c*h*g+f*p*u,this._w=c*h*u-f*p*g;break;case"ZYX":this._x=f*h*u-c*p*g,this._y=c*p*u+f*h*g,this._z=c*h*g-f*p*u,this._w=c*h*u+f*p*g;break;case"YZX":this._x=f*h*u+c*p*g,this._y=c*p*u+f*h*g,this._z=c*h*g-f*p*u,this._w=c*h*u-f*p*g;break;case"XZY":this._x=f*h*u-c*p*g,this._y=c*p*u-f*h*g,this._z=c*h*g+f*p*u,this._w=c*h*u+f*p*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=n+a+u;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(h-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(n>a&&n>u){let p=2*Math.sqrt(1+n-a-u);this._w=(h-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>u){let p=2*Math.sqrt(1+a-n-u);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+u-n-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<Number.EPSILON?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(bn(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let p=1-e;return this._w=p*o+e*this._w,this._x=p*n+e*this._x,this._y=p*s+e*this._y,this._z=p*r+e*this._z,this.normalize(),this}let c=Math.sqrt(l),h=Math.atan2(c,a),u=Math.sin((1-e)*h)/c,f=Math.sin(e*h)/c;return this._w=o*u+this._w*f,this._x=n*u+this._x*f,this._y=s*u+this._y*f,this._z=r*u+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},L=class{constructor(t=0,e=0,n=0){L.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Mm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Mm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Mh.copy(this).projectOnVector(t),this.sub(Mh)}reflect(t){return this.sub(Mh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(bn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Mh=new L,Mm=new Pe,Ei=class{constructor(t=new L(1/0,1/0,1/0),e=new L(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(xi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(xi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=xi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,xi):xi.fromBufferAttribute(r,o),xi.applyMatrix4(t.matrixWorld),this.expandByPoint(xi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Ga.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ga.copy(n.boundingBox)),Ga.applyMatrix4(t.matrixWorld),this.union(Ga)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,xi),xi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Fo),Wa.subVectors(this.max,Fo),Nr.subVectors(t.a,Fo),Or.subVectors(t.b,Fo),Fr.subVectors(t.c,Fo),_s.subVectors(Or,Nr),xs.subVectors(Fr,Or),Gs.subVectors(Nr,Fr);let e=[0,-_s.z,_s.y,0,-xs.z,xs.y,0,-Gs.z,Gs.y,_s.z,0,-_s.x,xs.z,0,-xs.x,Gs.z,0,-Gs.x,-_s.y,_s.x,0,-xs.y,xs.x,0,-Gs.y,Gs.x,0];return!bh(e,Nr,Or,Fr,Wa)||(e=[1,0,0,0,1,0,0,0,1],!bh(e,Nr,Or,Fr,Wa))?!1:(Xa.crossVectors(_s,xs),e=[Xa.x,Xa.y,Xa.z],bh(e,Nr,Or,Fr,Wa))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,xi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(xi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ki[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ki[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ki[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ki[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ki[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ki[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ki[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ki[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ki),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}},Ki=[new L,new L,new L,new L,new L,new L,new L,new L],xi=new L,Ga=new Ei,Nr=new L,Or=new L,Fr=new L,_s=new L,xs=new L,Gs=new L,Fo=new L,Wa=new L,Xa=new L,Ws=new L;function bh(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Ws.fromArray(i,r);let a=s.x*Math.abs(Ws.x)+s.y*Math.abs(Ws.y)+s.z*Math.abs(Ws.z),l=t.dot(Ws),c=e.dot(Ws),h=n.dot(Ws);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Cv=new Ei,ko=new L,Sh=new L,so=class{constructor(t=new L,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Cv.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ko.subVectors(t,this.center);let e=ko.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(ko,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Sh.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ko.copy(t.center).add(Sh)),this.expandByPoint(ko.copy(t.center).sub(Sh))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}},Ji=new L,wh=new L,qa=new L,ys=new L,Eh=new L,Ya=new L,Ah=new L,ro=class{constructor(t=new L,e=new L(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ji)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ji.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ji.copy(this.origin).addScaledVector(this.direction,e),Ji.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){wh.copy(t).add(e).multiplyScalar(.5),qa.copy(e).sub(t).normalize(),ys.copy(this.origin).sub(wh);let r=t.distanceTo(e)*.5,o=-this.direction.dot(qa),a=ys.dot(this.direction),l=-ys.dot(qa),c=ys.lengthSq(),h=Math.abs(1-o*o),u,f,p,g;if(h>0)if(u=o*l-a,f=o*a-l,g=r*h,u>=0)if(f>=-g)if(f<=g){let x=1/h;u*=x,f*=x,p=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;else f<=-g?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),p=-u*u+f*(f+2*l)+c):f<=g?(u=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),p=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(wh).addScaledVector(qa,f),p}intersectSphere(t,e){Ji.subVectors(t.center,this.origin);let n=Ji.dot(this.direction),s=Ji.dot(Ji)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Ji)!==null}intersectTriangle(t,e,n,s,r){Eh.subVectors(e,t),Ya.subVectors(n,t),Ah.crossVectors(Eh,Ya);let o=this.direction.dot(Ah),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;ys.subVectors(this.origin,t);let l=a*this.direction.dot(Ya.crossVectors(ys,Ya));if(l<0)return null;let c=a*this.direction.dot(Eh.cross(ys));if(c<0||l+c>o)return null;let h=-a*ys.dot(Ah);return h<0?null:this.at(h/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},He=class{constructor(t,e,n,s,r,o,a,l,c,h,u,f,p,g,x,m){He.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,f,p,g,x,m)}set(t,e,n,s,r,o,a,l,c,h,u,f,p,g,x,m){let d=this.elements;return d[0]=t,d[4]=e,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=h,d[10]=u,d[14]=f,d[3]=p,d[7]=g,d[11]=x,d[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new He().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){let e=this.elements,n=t.elements,s=1/kr.setFromMatrixColumn(t,0).length(),r=1/kr.setFromMatrixColumn(t,1).length(),o=1/kr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,p=o*u,g=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=p+g*c,e[5]=f-x*c,e[9]=-a*l,e[2]=x-f*c,e[6]=g+p*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*h,p=l*u,g=c*h,x=c*u;e[0]=f+x*a,e[4]=g*a-p,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=p*a-g,e[6]=x+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*h,p=l*u,g=c*h,x=c*u;e[0]=f-x*a,e[4]=-o*u,e[8]=g+p*a,e[1]=p+g*a,e[5]=o*h,e[9]=x-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*h,p=o*u,g=a*h,x=a*u;e[0]=l*h,e[4]=g*c-p,e[8]=f*c+x,e[1]=l*u,e[5]=x*c+f,e[9]=p*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,p=o*c,g=a*l,x=a*c;e[0]=l*h,e[4]=x-f*u,e[8]=g*u+p,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=p*u+g,e[10]=f-x*u}else if(t.order==="XZY"){let f=o*l,p=o*c,g=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+x,e[5]=o*h,e[9]=p*u-g,e[2]=g*u-p,e[6]=a*h,e[10]=x*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Rv,t,Pv)}lookAt(t,e,n){let s=this.elements;return $n.subVectors(t,e),$n.lengthSq()===0&&($n.z=1),$n.normalize(),vs.crossVectors(n,$n),vs.lengthSq()===0&&(Math.abs(n.z)===1?$n.x+=1e-4:$n.z+=1e-4,$n.normalize(),vs.crossVectors(n,$n)),vs.normalize(),$a.crossVectors($n,vs),s[0]=vs.x,s[4]=$a.x,s[8]=$n.x,s[1]=vs.y,s[5]=$a.y,s[9]=$n.y,s[2]=vs.z,s[6]=$a.z,s[10]=$n.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],p=n[13],g=n[2],x=n[6],m=n[10],d=n[14],M=n[3],b=n[7],y=n[11],U=n[15],C=s[0],D=s[4],O=s[8],A=s[12],S=s[1],R=s[5],G=s[9],F=s[13],W=s[2],J=s[6],K=s[10],Q=s[14],tt=s[3],ut=s[7],ct=s[11],mt=s[15];return r[0]=o*C+a*S+l*W+c*tt,r[4]=o*D+a*R+l*J+c*ut,r[8]=o*O+a*G+l*K+c*ct,r[12]=o*A+a*F+l*Q+c*mt,r[1]=h*C+u*S+f*W+p*tt,r[5]=h*D+u*R+f*J+p*ut,r[9]=h*O+u*G+f*K+p*ct,r[13]=h*A+u*F+f*Q+p*mt,r[2]=g*C+x*S+m*W+d*tt,r[6]=g*D+x*R+m*J+d*ut,r[10]=g*O+x*G+m*K+d*ct,r[14]=g*A+x*F+m*Q+d*mt,r[3]=M*C+b*S+y*W+U*tt,r[7]=M*D+b*R+y*J+U*ut,r[11]=M*O+b*G+y*K+U*ct,r[15]=M*A+b*F+y*Q+U*mt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],p=t[14],g=t[3],x=t[7],m=t[11],d=t[15];return g*(+r*l*u-s*c*u-r*a*f+n*c*f+s*a*p-n*l*p)+x*(+e*l*p-e*c*f+r*o*f-s*o*p+s*c*h-r*l*h)+m*(+e*c*u-e*a*p-r*o*u+n*o*p+r*a*h-n*c*h)+d*(-s*a*h-e*l*u+e*a*f+s*o*u-n*o*f+n*l*h)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],p=t[11],g=t[12],x=t[13],m=t[14],d=t[15],M=u*m*c-x*f*c+x*l*p-a*m*p-u*l*d+a*f*d,b=g*f*c-h*m*c-g*l*p+o*m*p+h*l*d-o*f*d,y=h*x*c-g*u*c+g*a*p-o*x*p-h*a*d+o*u*d,U=g*u*l-h*x*l-g*a*f+o*x*f+h*a*m-o*u*m,C=e*M+n*b+s*y+r*U;if(C===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/C;return t[0]=M*D,t[1]=(x*f*r-u*m*r-x*s*p+n*m*p+u*s*d-n*f*d)*D,t[2]=(a*m*r-x*l*r+x*s*c-n*m*c-a*s*d+n*l*d)*D,t[3]=(u*l*r-a*f*r-u*s*c+n*f*c+a*s*p-n*l*p)*D,t[4]=b*D,t[5]=(h*m*r-g*f*r+g*s*p-e*m*p-h*s*d+e*f*d)*D,t[6]=(g*l*r-o*m*r-g*s*c+e*m*c+o*s*d-e*l*d)*D,t[7]=(o*f*r-h*l*r+h*s*c-e*f*c-o*s*p+e*l*p)*D,t[8]=y*D,t[9]=(g*u*r-h*x*r-g*n*p+e*x*p+h*n*d-e*u*d)*D,t[10]=(o*x*r-g*a*r+g*n*c-e*x*c-o*n*d+e*a*d)*D,t[11]=(h*a*r-o*u*r-h*n*c+e*u*c+o*n*p-e*a*p)*D,t[12]=U*D,t[13]=(h*x*s-g*u*s+g*n*f-e*x*f-h*n*m+e*u*m)*D,t[14]=(g*a*s-o*x*s-g*n*l+e*x*l+o*n*m-e*a*m)*D,t[15]=(o*u*s-h*a*s+h*n*l-e*u*l-o*n*f+e*a*f)*D,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,p=r*h,g=r*u,x=o*h,m=o*u,d=a*u,M=l*c,b=l*h,y=l*u,U=n.x,C=n.y,D=n.z;return s[0]=(1-(x+d))*U,s[1]=(p+y)*U,s[2]=(g-b)*U,s[3]=0,s[4]=(p-y)*C,s[5]=(1-(f+d))*C,s[6]=(m+M)*C,s[7]=0,s[8]=(g+b)*D,s[9]=(m-M)*D,s[10]=(1-(f+x))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements,r=kr.set(s[0],s[1],s[2]).length(),o=kr.set(s[4],s[5],s[6]).length(),a=kr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],yi.copy(this);let c=1/r,h=1/o,u=1/a;return yi.elements[0]*=c,yi.elements[1]*=c,yi.elements[2]*=c,yi.elements[4]*=h,yi.elements[5]*=h,yi.elements[6]*=h,yi.elements[8]*=u,yi.elements[9]*=u,yi.elements[10]*=u,e.setFromRotationMatrix(yi),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=is){let l=this.elements,c=2*r/(e-t),h=2*r/(n-s),u=(e+t)/(e-t),f=(n+s)/(n-s),p,g;if(a===is)p=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===xl)p=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=h,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=is){let l=this.elements,c=1/(e-t),h=1/(n-s),u=1/(o-r),f=(e+t)*c,p=(n+s)*h,g,x;if(a===is)g=(o+r)*u,x=-2*u;else if(a===xl)g=r*u,x=-1*u;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*h,l[9]=0,l[13]=-p,l[2]=0,l[6]=0,l[10]=x,l[14]=-g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},kr=new L,yi=new He,Rv=new L(0,0,0),Pv=new L(1,1,1),vs=new L,$a=new L,$n=new L,bm=new He,Sm=new Pe,Ai=class{constructor(t=0,e=0,n=0,s=Ai.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(bn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-bn(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(bn(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-bn(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(bn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-bn(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,p),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return bm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(bm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Sm.setFromEuler(this),this.setFromQuaternion(Sm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ai.DEFAULT_ORDER="XYZ";var bl=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Iv=0,wm=new L,Br=new Pe,ji=new He,Za=new L,Bo=new L,Lv=new L,Dv=new Pe,Em=new L(1,0,0),Am=new L(0,1,0),Tm=new L(0,0,1),Cm={type:"added"},Uv={type:"removed"},zr={type:"childadded",child:null},Th={type:"childremoved",child:null},wn=class extends os{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Iv++}),this.uuid=ho(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=wn.DEFAULT_UP.clone();let t=new L,e=new Ai,n=new Pe,s=new L(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new He},normalMatrix:{value:new jt}}),this.matrix=new He,this.matrixWorld=new He,this.matrixAutoUpdate=wn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new bl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Br.setFromAxisAngle(t,e),this.quaternion.multiply(Br),this}rotateOnWorldAxis(t,e){return Br.setFromAxisAngle(t,e),this.quaternion.premultiply(Br),this}rotateX(t){return this.rotateOnAxis(Em,t)}rotateY(t){return this.rotateOnAxis(Am,t)}rotateZ(t){return this.rotateOnAxis(Tm,t)}translateOnAxis(t,e){return wm.copy(t).applyQuaternion(this.quaternion),this.position.add(wm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Em,t)}translateY(t){return this.translateOnAxis(Am,t)}translateZ(t){return this.translateOnAxis(Tm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ji.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Za.copy(t):Za.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Bo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ji.lookAt(Bo,Za,this.up):ji.lookAt(Za,Bo,this.up),this.quaternion.setFromRotationMatrix(ji),s&&(ji.extractRotation(s.matrixWorld),Br.setFromRotationMatrix(ji),this.quaternion.premultiply(Br.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Cm),zr.child=t,this.dispatchEvent(zr),zr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Uv),Th.child=t,this.dispatchEvent(Th),Th.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ji.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ji.multiply(t.parent.matrixWorld)),t.applyMatrix4(ji),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Cm),zr.child=t,this.dispatchEvent(zr),zr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Bo,t,Lv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Bo,Dv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){let n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),p=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),p.length>0&&(n.animations=p),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}};wn.DEFAULT_UP=new L(0,1,0);wn.DEFAULT_MATRIX_AUTO_UPDATE=!0;wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var vi=new L,Qi=new L,Ch=new L,ts=new L,Vr=new L,Hr=new L,Rm=new L,Rh=new L,Ph=new L,Ih=new L,Lh=new Ve,Dh=new Ve,Uh=new Ve,Kn=class{constructor(t=new L,e=new L,n=new L){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),vi.subVectors(t,e),s.cross(vi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){vi.subVectors(s,e),Qi.subVectors(n,e),Ch.subVectors(t,e);let o=vi.dot(vi),a=vi.dot(Qi),l=vi.dot(Ch),c=Qi.dot(Qi),h=Qi.dot(Ch),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,p=(c*l-a*h)*f,g=(o*h-a*l)*f;return r.set(1-p-g,g,p)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,ts)===null?!1:ts.x>=0&&ts.y>=0&&ts.x+ts.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ts.x),l.addScaledVector(o,ts.y),l.addScaledVector(a,ts.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return Lh.setScalar(0),Dh.setScalar(0),Uh.setScalar(0),Lh.fromBufferAttribute(t,e),Dh.fromBufferAttribute(t,n),Uh.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Lh,r.x),o.addScaledVector(Dh,r.y),o.addScaledVector(Uh,r.z),o}static isFrontFacing(t,e,n,s){return vi.subVectors(n,e),Qi.subVectors(t,e),vi.cross(Qi).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return vi.subVectors(this.c,this.b),Qi.subVectors(this.a,this.b),vi.cross(Qi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return Kn.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return Kn.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return Kn.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return Kn.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return Kn.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Vr.subVectors(s,n),Hr.subVectors(r,n),Rh.subVectors(t,n);let l=Vr.dot(Rh),c=Hr.dot(Rh);if(l<=0&&c<=0)return e.copy(n);Ph.subVectors(t,s);let h=Vr.dot(Ph),u=Hr.dot(Ph);if(h>=0&&u<=h)return e.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0)return o=l/(l-h),e.copy(n).addScaledVector(Vr,o);Ih.subVectors(t,r);let p=Vr.dot(Ih),g=Hr.dot(Ih);if(g>=0&&p<=g)return e.copy(r);let x=p*c-l*g;if(x<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(n).addScaledVector(Hr,a);let m=h*g-p*u;if(m<=0&&u-h>=0&&p-g>=0)return Rm.subVectors(r,s),a=(u-h)/(u-h+(p-g)),e.copy(s).addScaledVector(Rm,a);let d=1/(m+x+f);return o=x*d,a=f*d,e.copy(n).addScaledVector(Vr,o).addScaledVector(Hr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Eg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ms={h:0,s:0,l:0},Ka={h:0,s:0,l:0};function Nh(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var se=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=hi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,le.toWorkingColorSpace(this,e),this}setRGB(t,e,n,s=le.workingColorSpace){return this.r=t,this.g=e,this.b=n,le.toWorkingColorSpace(this,s),this}setHSL(t,e,n,s=le.workingColorSpace){if(t=mf(t,1),e=bn(e,0,1),n=bn(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Nh(o,r,t+1/3),this.g=Nh(o,r,t),this.b=Nh(o,r,t-1/3)}return le.toWorkingColorSpace(this,s),this}setStyle(t,e=hi){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=hi){let n=Eg[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ss(t.r),this.g=ss(t.g),this.b=ss(t.b),this}copyLinearToSRGB(t){return this.r=Jr(t.r),this.g=Jr(t.g),this.b=Jr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=hi){return le.fromWorkingColorSpace(Mn.copy(this),t),Math.round(bn(Mn.r*255,0,255))*65536+Math.round(bn(Mn.g*255,0,255))*256+Math.round(bn(Mn.b*255,0,255))}getHexString(t=hi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=le.workingColorSpace){le.fromWorkingColorSpace(Mn.copy(this),e);let n=Mn.r,s=Mn.g,r=Mn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=le.workingColorSpace){return le.fromWorkingColorSpace(Mn.copy(this),e),t.r=Mn.r,t.g=Mn.g,t.b=Mn.b,t}getStyle(t=hi){le.fromWorkingColorSpace(Mn.copy(this),t);let e=Mn.r,n=Mn.g,s=Mn.b;return t!==hi?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Ms),this.setHSL(Ms.h+t,Ms.s+e,Ms.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Ms),t.getHSL(Ka);let n=Xo(Ms.h,Ka.h,e),s=Xo(Ms.s,Ka.s,e),r=Xo(Ms.l,Ka.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Mn=new se;se.NAMES=Eg;var Nv=0,er=class extends os{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Nv++}),this.uuid=ho(),this.name="",this.blending=Zr,this.side=As,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=qh,this.blendDst=Yh,this.blendEquation=Ks,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new se(0,0,0),this.blendAlpha=0,this.depthFunc=Qr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=fm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Dr,this.stencilZFail=Dr,this.stencilZPass=Dr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==Zr&&(n.blending=this.blending),this.side!==As&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==qh&&(n.blendSrc=this.blendSrc),this.blendDst!==Yh&&(n.blendDst=this.blendDst),this.blendEquation!==Ks&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==Qr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==fm&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Dr&&(n.stencilFail=this.stencilFail),this.stencilZFail!==Dr&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==Dr&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}},Sl=class extends er{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new se(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ai,this.combine=hg,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var Ze=new L,Ja=new Qt,Ke=class{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=dm,this.updateRanges=[],this.gpuType=ns,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Ja.fromBufferAttribute(this,e),Ja.applyMatrix3(t),this.setXY(e,Ja.x,Ja.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Ze.fromBufferAttribute(this,e),Ze.applyMatrix3(t),this.setXYZ(e,Ze.x,Ze.y,Ze.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Ze.fromBufferAttribute(this,e),Ze.applyMatrix4(t),this.setXYZ(e,Ze.x,Ze.y,Ze.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Ze.fromBufferAttribute(this,e),Ze.applyNormalMatrix(t),this.setXYZ(e,Ze.x,Ze.y,Ze.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Ze.fromBufferAttribute(this,e),Ze.transformDirection(t),this.setXYZ(e,Ze.x,Ze.y,Ze.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=Yr(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Ln(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Yr(e,this.array)),e}setX(t,e){return this.normalized&&(e=Ln(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Yr(e,this.array)),e}setY(t,e){return this.normalized&&(e=Ln(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Yr(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Ln(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Yr(e,this.array)),e}setW(t,e){return this.normalized&&(e=Ln(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Ln(e,this.array),n=Ln(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=Ln(e,this.array),n=Ln(n,this.array),s=Ln(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=Ln(e,this.array),n=Ln(n,this.array),s=Ln(s,this.array),r=Ln(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==dm&&(t.usage=this.usage),t}};var wl=class extends Ke{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var El=class extends Ke{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var _n=class extends Ke{constructor(t,e,n){super(new Float32Array(t),e,n)}},Ov=0,ci=new He,Oh=new wn,Gr=new L,Zn=new Ei,zo=new Ei,mn=new L,nn=class extends os{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Ov++}),this.uuid=ho(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(wg(t)?El:wl)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new jt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return ci.makeRotationFromQuaternion(t),this.applyMatrix4(ci),this}rotateX(t){return ci.makeRotationX(t),this.applyMatrix4(ci),this}rotateY(t){return ci.makeRotationY(t),this.applyMatrix4(ci),this}rotateZ(t){return ci.makeRotationZ(t),this.applyMatrix4(ci),this}translate(t,e,n){return ci.makeTranslation(t,e,n),this.applyMatrix4(ci),this}scale(t,e,n){return ci.makeScale(t,e,n),this.applyMatrix4(ci),this}lookAt(t){return Oh.lookAt(t),Oh.updateMatrix(),this.applyMatrix4(Oh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Gr).negate(),this.translate(Gr.x,Gr.y,Gr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new _n(n,3))}else{for(let n=0,s=e.count;n<s;n++){let r=t[n];e.setXYZ(n,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ei);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new L(-1/0,-1/0,-1/0),new L(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];Zn.setFromBufferAttribute(r),this.morphTargetsRelative?(mn.addVectors(this.boundingBox.min,Zn.min),this.boundingBox.expandByPoint(mn),mn.addVectors(this.boundingBox.max,Zn.max),this.boundingBox.expandByPoint(mn)):(this.boundingBox.expandByPoint(Zn.min),this.boundingBox.expandByPoint(Zn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new so);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new L,1/0);return}if(t){let n=this.boundingSphere.center;if(Zn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];zo.setFromBufferAttribute(a),this.morphTargetsRelative?(mn.addVectors(Zn.min,zo.min),Zn.expandByPoint(mn),mn.addVectors(Zn.max,zo.max),Zn.expandByPoint(mn)):(Zn.expandByPoint(zo.min),Zn.expandByPoint(zo.max))}Zn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)mn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(mn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)mn.fromBufferAttribute(a,c),l&&(Gr.fromBufferAttribute(t,c),mn.add(Gr)),s=Math.max(s,n.distanceToSquared(mn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Ke(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let O=0;O<n.count;O++)a[O]=new L,l[O]=new L;let c=new L,h=new L,u=new L,f=new Qt,p=new Qt,g=new Qt,x=new L,m=new L;function d(O,A,S){c.fromBufferAttribute(n,O),h.fromBufferAttribute(n,A),u.fromBufferAttribute(n,S),f.fromBufferAttribute(r,O),p.fromBufferAttribute(r,A),g.fromBufferAttribute(r,S),h.sub(c),u.sub(c),p.sub(f),g.sub(f);let R=1/(p.x*g.y-g.x*p.y);isFinite(R)&&(x.copy(h).multiplyScalar(g.y).addScaledVector(u,-p.y).multiplyScalar(R),m.copy(u).multiplyScalar(p.x).addScaledVector(h,-g.x).multiplyScalar(R),a[O].add(x),a[A].add(x),a[S].add(x),l[O].add(m),l[A].add(m),l[S].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let O=0,A=M.length;O<A;++O){let S=M[O],R=S.start,G=S.count;for(let F=R,W=R+G;F<W;F+=3)d(t.getX(F+0),t.getX(F+1),t.getX(F+2))}let b=new L,y=new L,U=new L,C=new L;function D(O){U.fromBufferAttribute(s,O),C.copy(U);let A=a[O];b.copy(A),b.sub(U.multiplyScalar(U.dot(A))).normalize(),y.crossVectors(C,A);let R=y.dot(l[O])<0?-1:1;o.setXYZW(O,b.x,b.y,b.z,R)}for(let O=0,A=M.length;O<A;++O){let S=M[O],R=S.start,G=S.count;for(let F=R,W=R+G;F<W;F+=3)D(t.getX(F+0)),D(t.getX(F+1)),D(t.getX(F+2))}}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new Ke(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,p=n.count;f<p;f++)n.setXYZ(f,0,0,0);let s=new L,r=new L,o=new L,a=new L,l=new L,c=new L,h=new L,u=new L;if(t)for(let f=0,p=t.count;f<p;f+=3){let g=t.getX(f+0),x=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,p=e.count;f<p;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)mn.fromBufferAttribute(t,e),mn.normalize(),t.setXYZ(e,mn.x,mn.y,mn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),p=0,g=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?p=l[x]*a.data.stride+a.offset:p=l[x]*h;for(let d=0;d<h;d++)f[g++]=c[p++]}return new Ke(f,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new nn,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],p=t(f,n);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let p=c[u];h.push(p.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone(e));let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,p=u.length;f<p;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},Pm=new He,Xs=new ro,ja=new so,Im=new L,Qa=new L,tl=new L,el=new L,Fh=new L,nl=new L,Lm=new L,il=new L,Le=class extends wn{constructor(t=new nn,e=new Sl){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){nl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Fh.fromBufferAttribute(u,t),o?nl.addScaledVector(Fh,h):nl.addScaledVector(Fh.sub(e),h))}e.add(nl)}return e}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),ja.copy(n.boundingSphere),ja.applyMatrix4(r),Xs.copy(t.ray).recast(t.near),!(ja.containsPoint(Xs.origin)===!1&&(Xs.intersectSphere(ja,Im)===null||Xs.origin.distanceToSquared(Im)>(t.far-t.near)**2))&&(Pm.copy(r).invert(),Xs.copy(t.ray).applyMatrix4(Pm),!(n.boundingBox!==null&&Xs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Xs)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=f.length;g<x;g++){let m=f[g],d=o[m.materialIndex],M=Math.max(m.start,p.start),b=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let y=M,U=b;y<U;y+=3){let C=a.getX(y),D=a.getX(y+1),O=a.getX(y+2);s=sl(this,d,t,n,c,h,u,C,D,O),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,p.start),x=Math.min(a.count,p.start+p.count);for(let m=g,d=x;m<d;m+=3){let M=a.getX(m),b=a.getX(m+1),y=a.getX(m+2);s=sl(this,o,t,n,c,h,u,M,b,y),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,x=f.length;g<x;g++){let m=f[g],d=o[m.materialIndex],M=Math.max(m.start,p.start),b=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let y=M,U=b;y<U;y+=3){let C=y,D=y+1,O=y+2;s=sl(this,d,t,n,c,h,u,C,D,O),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,p.start),x=Math.min(l.count,p.start+p.count);for(let m=g,d=x;m<d;m+=3){let M=m,b=m+1,y=m+2;s=sl(this,o,t,n,c,h,u,M,b,y),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Fv(i,t,e,n,s,r,o,a){let l;if(t.side===kn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===As,a),l===null)return null;il.copy(a),il.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(il);return c<e.near||c>e.far?null:{distance:c,point:il.clone(),object:i}}function sl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Qa),i.getVertexPosition(l,tl),i.getVertexPosition(c,el);let h=Fv(i,t,e,n,Qa,tl,el,Lm);if(h){let u=new L;Kn.getBarycoord(Lm,Qa,tl,el,u),s&&(h.uv=Kn.getInterpolatedAttribute(s,a,l,c,u,new Qt)),r&&(h.uv1=Kn.getInterpolatedAttribute(r,a,l,c,u,new Qt)),o&&(h.normal=Kn.getInterpolatedAttribute(o,a,l,c,u,new L),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new L,materialIndex:0};Kn.getNormal(Qa,tl,el,f.normal),h.face=f,h.barycoord=u}return h}var jn=class extends nn{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,p=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new _n(c,3)),this.setAttribute("normal",new _n(h,3)),this.setAttribute("uv",new _n(u,2));function g(x,m,d,M,b,y,U,C,D,O,A){let S=y/D,R=U/O,G=y/2,F=U/2,W=C/2,J=D+1,K=O+1,Q=0,tt=0,ut=new L;for(let ct=0;ct<K;ct++){let mt=ct*R-F;for(let vt=0;vt<J;vt++){let pt=vt*S-G;ut[x]=pt*M,ut[m]=mt*b,ut[d]=W,c.push(ut.x,ut.y,ut.z),ut[x]=0,ut[m]=0,ut[d]=C>0?1:-1,h.push(ut.x,ut.y,ut.z),u.push(vt/D),u.push(1-ct/O),Q+=1}}for(let ct=0;ct<O;ct++)for(let mt=0;mt<D;mt++){let vt=f+mt+J*ct,pt=f+mt+J*(ct+1),it=f+(mt+1)+J*(ct+1),at=f+(mt+1)+J*ct;l.push(vt,pt,at),l.push(pt,it,at),tt+=6}a.addGroup(p,tt,A),p+=tt,f+=Q}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new jn(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};function oo(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function Dn(i){let t={};for(let e=0;e<i.length;e++){let n=oo(i[e]);for(let s in n)t[s]=n[s]}return t}function kv(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Ag(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:le.workingColorSpace}var Bv={clone:oo,merge:Dn},zv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Vv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ti=class extends er{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=zv,this.fragmentShader=Vv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=oo(t.uniforms),this.uniformsGroups=kv(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}},Al=class extends wn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new He,this.projectionMatrix=new He,this.projectionMatrixInverse=new He,this.coordinateSystem=is}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},bs=new L,Dm=new Qt,Um=new Qt,Un=class extends Al{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Zo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Wo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Zo*2*Math.atan(Math.tan(Wo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){bs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(bs.x,bs.y).multiplyScalar(-t/bs.z),bs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(bs.x,bs.y).multiplyScalar(-t/bs.z)}getViewSize(t,e){return this.getViewBounds(t,Dm,Um),e.subVectors(Um,Dm)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Wo*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},Wr=-90,Xr=1,Nu=class extends wn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Un(Wr,Xr,t,e);s.layers=this.layers,this.add(s);let r=new Un(Wr,Xr,t,e);r.layers=this.layers,this.add(r);let o=new Un(Wr,Xr,t,e);o.layers=this.layers,this.add(o);let a=new Un(Wr,Xr,t,e);a.layers=this.layers,this.add(a);let l=new Un(Wr,Xr,t,e);l.layers=this.layers,this.add(l);let c=new Un(Wr,Xr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===is)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===xl)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=x,t.setRenderTarget(n,5,s),t.render(e,h),t.setRenderTarget(u,f,p),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Tl=class extends Sn{constructor(t,e,n,s,r,o,a,l,c,h){t=t!==void 0?t:[],e=e!==void 0?e:to,super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Ou=class extends as{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Tl(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:zi}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new jn(5,5,5),r=new Ti({name:"CubemapFromEquirect",uniforms:oo(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:kn,blending:ws});r.uniforms.tEquirect.value=e;let o=new Le(s,r),a=e.minFilter;return e.minFilter===Qs&&(e.minFilter=zi),new Nu(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e,n,s){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},kh=new L,Hv=new L,Gv=new jt,Mi=class{constructor(t=new L(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=kh.subVectors(n,e).cross(Hv.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){let n=t.delta(kh),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Gv.getNormalMatrix(t),s=this.coplanarPoint(kh).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},qs=new so,rl=new L,Cl=class{constructor(t=new Mi,e=new Mi,n=new Mi,s=new Mi,r=new Mi,o=new Mi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=is){let n=this.planes,s=t.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],h=s[5],u=s[6],f=s[7],p=s[8],g=s[9],x=s[10],m=s[11],d=s[12],M=s[13],b=s[14],y=s[15];if(n[0].setComponents(l-r,f-c,m-p,y-d).normalize(),n[1].setComponents(l+r,f+c,m+p,y+d).normalize(),n[2].setComponents(l+o,f+h,m+g,y+M).normalize(),n[3].setComponents(l-o,f-h,m-g,y-M).normalize(),n[4].setComponents(l-a,f-u,m-x,y-b).normalize(),e===is)n[5].setComponents(l+a,f+u,m+x,y+b).normalize();else if(e===xl)n[5].setComponents(a,u,x,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),qs.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),qs.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(qs)}intersectsSprite(t){return qs.center.set(0,0,0),qs.radius=.7071067811865476,qs.applyMatrix4(t.matrixWorld),this.intersectsSphere(qs)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(rl.x=s.normal.x>0?t.max.x:t.min.x,rl.y=s.normal.y>0?t.max.y:t.min.y,rl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(rl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};function Tg(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function Wv(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((p,g)=>p.start-g.start);let f=0;for(let p=1;p<u.length;p++){let g=u[f],x=u[p];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++f,u[f]=x)}u.length=f+1;for(let p=0,g=u.length;p<g;p++){let x=u[p];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var ao=class extends nn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,p=[],g=[],x=[],m=[];for(let d=0;d<h;d++){let M=d*f-o;for(let b=0;b<c;b++){let y=b*u-r;g.push(y,-M,0),x.push(0,0,1),m.push(b/a),m.push(1-d/l)}}for(let d=0;d<l;d++)for(let M=0;M<a;M++){let b=M+c*d,y=M+c*(d+1),U=M+1+c*(d+1),C=M+1+c*d;p.push(b,y,C),p.push(y,U,C)}this.setIndex(p),this.setAttribute("position",new _n(g,3)),this.setAttribute("normal",new _n(x,3)),this.setAttribute("uv",new _n(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new ao(t.width,t.height,t.widthSegments,t.heightSegments)}},Xv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,qv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Yv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,$v=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Zv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Kv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Jv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,jv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Qv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,tM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,eM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,nM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,iM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,sM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,rM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,oM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,aM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,lM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,cM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,hM=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,uM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,fM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,dM=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,pM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,mM=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,gM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,_M=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,xM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,yM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,vM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,MM="gl_FragColor = linearToOutputTexel( gl_FragColor );",bM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,SM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,wM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,EM=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,AM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,TM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,CM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,RM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,PM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,IM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,LM=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,DM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,UM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,NM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,OM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,FM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,kM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,BM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,zM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,VM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,HM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,GM=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,WM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,XM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,qM=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,YM=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,$M=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ZM=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,KM=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,JM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,jM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,QM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,tb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,eb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,nb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ib=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,sb=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,rb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ob=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,ab=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,lb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,cb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,hb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ub=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,fb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,db=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,pb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,mb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,gb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,_b=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,xb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,yb=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,vb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Mb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,bb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Sb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,wb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Eb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Ab=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,Tb=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Cb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Rb=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Pb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Ib=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Lb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Db=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Ub=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Nb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Ob=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Fb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,kb=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Bb=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,zb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Vb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Hb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Gb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Wb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Xb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,qb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Yb=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$b=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Zb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Kb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Jb=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,jb=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Qb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,tS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,eS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nS=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,iS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,sS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,rS=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,oS=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,aS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,lS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,cS=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,hS=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,uS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,fS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,dS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,pS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,mS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,gS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,_S=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,yS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,vS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,MS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,bS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,SS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ne={alphahash_fragment:Xv,alphahash_pars_fragment:qv,alphamap_fragment:Yv,alphamap_pars_fragment:$v,alphatest_fragment:Zv,alphatest_pars_fragment:Kv,aomap_fragment:Jv,aomap_pars_fragment:jv,batching_pars_vertex:Qv,batching_vertex:tM,begin_vertex:eM,beginnormal_vertex:nM,bsdfs:iM,iridescence_fragment:sM,bumpmap_pars_fragment:rM,clipping_planes_fragment:oM,clipping_planes_pars_fragment:aM,clipping_planes_pars_vertex:lM,clipping_planes_vertex:cM,color_fragment:hM,color_pars_fragment:uM,color_pars_vertex:fM,color_vertex:dM,common:pM,cube_uv_reflection_fragment:mM,defaultnormal_vertex:gM,displacementmap_pars_vertex:_M,displacementmap_vertex:xM,emissivemap_fragment:yM,emissivemap_pars_fragment:vM,colorspace_fragment:MM,colorspace_pars_fragment:bM,envmap_fragment:SM,envmap_common_pars_fragment:wM,envmap_pars_fragment:EM,envmap_pars_vertex:AM,envmap_physical_pars_fragment:FM,envmap_vertex:TM,fog_vertex:CM,fog_pars_vertex:RM,fog_fragment:PM,fog_pars_fragment:IM,gradientmap_pars_fragment:LM,lightmap_pars_fragment:DM,lights_lambert_fragment:UM,lights_lambert_pars_fragment:NM,lights_pars_begin:OM,lights_toon_fragment:kM,lights_toon_pars_fragment:BM,lights_phong_fragment:zM,lights_phong_pars_fragment:VM,lights_physical_fragment:HM,lights_physical_pars_fragment:GM,lights_fragment_begin:WM,lights_fragment_maps:XM,lights_fragment_end:qM,logdepthbuf_fragment:YM,logdepthbuf_pars_fragment:$M,logdepthbuf_pars_vertex:ZM,logdepthbuf_vertex:KM,map_fragment:JM,map_pars_fragment:jM,map_particle_fragment:QM,map_particle_pars_fragment:tb,metalnessmap_fragment:eb,metalnessmap_pars_fragment:nb,morphinstance_vertex:ib,morphcolor_vertex:sb,morphnormal_vertex:rb,morphtarget_pars_vertex:ob,morphtarget_vertex:ab,normal_fragment_begin:lb,normal_fragment_maps:cb,normal_pars_fragment:hb,normal_pars_vertex:ub,normal_vertex:fb,normalmap_pars_fragment:db,clearcoat_normal_fragment_begin:pb,clearcoat_normal_fragment_maps:mb,clearcoat_pars_fragment:gb,iridescence_pars_fragment:_b,opaque_fragment:xb,packing:yb,premultiplied_alpha_fragment:vb,project_vertex:Mb,dithering_fragment:bb,dithering_pars_fragment:Sb,roughnessmap_fragment:wb,roughnessmap_pars_fragment:Eb,shadowmap_pars_fragment:Ab,shadowmap_pars_vertex:Tb,shadowmap_vertex:Cb,shadowmask_pars_fragment:Rb,skinbase_vertex:Pb,skinning_pars_vertex:Ib,skinning_vertex:Lb,skinnormal_vertex:Db,specularmap_fragment:Ub,specularmap_pars_fragment:Nb,tonemapping_fragment:Ob,tonemapping_pars_fragment:Fb,transmission_fragment:kb,transmission_pars_fragment:Bb,uv_pars_fragment:zb,uv_pars_vertex:Vb,uv_vertex:Hb,worldpos_vertex:Gb,background_vert:Wb,background_frag:Xb,backgroundCube_vert:qb,backgroundCube_frag:Yb,cube_vert:$b,cube_frag:Zb,depth_vert:Kb,depth_frag:Jb,distanceRGBA_vert:jb,distanceRGBA_frag:Qb,equirect_vert:tS,equirect_frag:eS,linedashed_vert:nS,linedashed_frag:iS,meshbasic_vert:sS,meshbasic_frag:rS,meshlambert_vert:oS,meshlambert_frag:aS,meshmatcap_vert:lS,meshmatcap_frag:cS,meshnormal_vert:hS,meshnormal_frag:uS,meshphong_vert:fS,meshphong_frag:dS,meshphysical_vert:pS,meshphysical_frag:mS,meshtoon_vert:gS,meshtoon_frag:_S,points_vert:xS,points_frag:yS,shadow_vert:vS,shadow_frag:MS,sprite_vert:bS,sprite_frag:SS},wt={common:{diffuse:{value:new se(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new jt},alphaMap:{value:null},alphaMapTransform:{value:new jt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new jt}},envmap:{envMap:{value:null},envMapRotation:{value:new jt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new jt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new jt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new jt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new jt},normalScale:{value:new Qt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new jt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new jt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new jt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new jt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new se(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new se(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new jt},alphaTest:{value:0},uvTransform:{value:new jt}},sprite:{diffuse:{value:new se(16777215)},opacity:{value:1},center:{value:new Qt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new jt},alphaMap:{value:null},alphaMapTransform:{value:new jt},alphaTest:{value:0}}},Bi={basic:{uniforms:Dn([wt.common,wt.specularmap,wt.envmap,wt.aomap,wt.lightmap,wt.fog]),vertexShader:ne.meshbasic_vert,fragmentShader:ne.meshbasic_frag},lambert:{uniforms:Dn([wt.common,wt.specularmap,wt.envmap,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.fog,wt.lights,{emissive:{value:new se(0)}}]),vertexShader:ne.meshlambert_vert,fragmentShader:ne.meshlambert_frag},phong:{uniforms:Dn([wt.common,wt.specularmap,wt.envmap,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.fog,wt.lights,{emissive:{value:new se(0)},specular:{value:new se(1118481)},shininess:{value:30}}]),vertexShader:ne.meshphong_vert,fragmentShader:ne.meshphong_frag},standard:{uniforms:Dn([wt.common,wt.envmap,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.roughnessmap,wt.metalnessmap,wt.fog,wt.lights,{emissive:{value:new se(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ne.meshphysical_vert,fragmentShader:ne.meshphysical_frag},toon:{uniforms:Dn([wt.common,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.gradientmap,wt.fog,wt.lights,{emissive:{value:new se(0)}}]),vertexShader:ne.meshtoon_vert,fragmentShader:ne.meshtoon_frag},matcap:{uniforms:Dn([wt.common,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.fog,{matcap:{value:null}}]),vertexShader:ne.meshmatcap_vert,fragmentShader:ne.meshmatcap_frag},points:{uniforms:Dn([wt.points,wt.fog]),vertexShader:ne.points_vert,fragmentShader:ne.points_frag},dashed:{uniforms:Dn([wt.common,wt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ne.linedashed_vert,fragmentShader:ne.linedashed_frag},depth:{uniforms:Dn([wt.common,wt.displacementmap]),vertexShader:ne.depth_vert,fragmentShader:ne.depth_frag},normal:{uniforms:Dn([wt.common,wt.bumpmap,wt.normalmap,wt.displacementmap,{opacity:{value:1}}]),vertexShader:ne.meshnormal_vert,fragmentShader:ne.meshnormal_frag},sprite:{uniforms:Dn([wt.sprite,wt.fog]),vertexShader:ne.sprite_vert,fragmentShader:ne.sprite_frag},background:{uniforms:{uvTransform:{value:new jt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ne.background_vert,fragmentShader:ne.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new jt}},vertexShader:ne.backgroundCube_vert,fragmentShader:ne.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ne.cube_vert,fragmentShader:ne.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ne.equirect_vert,fragmentShader:ne.equirect_frag},distanceRGBA:{uniforms:Dn([wt.common,wt.displacementmap,{referencePosition:{value:new L},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ne.distanceRGBA_vert,fragmentShader:ne.distanceRGBA_frag},shadow:{uniforms:Dn([wt.lights,wt.fog,{color:{value:new se(0)},opacity:{value:1}}]),vertexShader:ne.shadow_vert,fragmentShader:ne.shadow_frag}};Bi.physical={uniforms:Dn([Bi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new jt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new jt},clearcoatNormalScale:{value:new Qt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new jt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new jt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new jt},sheen:{value:0},sheenColor:{value:new se(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new jt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new jt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new jt},transmissionSamplerSize:{value:new Qt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new jt},attenuationDistance:{value:0},attenuationColor:{value:new se(0)},specularColor:{value:new se(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new jt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new jt},anisotropyVector:{value:new Qt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new jt}}]),vertexShader:ne.meshphysical_vert,fragmentShader:ne.meshphysical_frag};var ol={r:0,b:0,g:0},Ys=new Ai,wS=new He;function ES(i,t,e,n,s,r,o){let a=new se(0),l=r===!0?0:1,c,h,u=null,f=0,p=null;function g(M){let b=M.isScene===!0?M.background:null;return b&&b.isTexture&&(b=(M.backgroundBlurriness>0?e:t).get(b)),b}function x(M){let b=!1,y=g(M);y===null?d(a,l):y&&y.isColor&&(d(y,1),b=!0);let U=i.xr.getEnvironmentBlendMode();U==="additive"?n.buffers.color.setClear(0,0,0,1,o):U==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||b)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(M,b){let y=g(b);y&&(y.isCubeTexture||y.mapping===kl)?(h===void 0&&(h=new Le(new jn(1,1,1),new Ti({name:"BackgroundCubeMaterial",uniforms:oo(Bi.backgroundCube.uniforms),vertexShader:Bi.backgroundCube.vertexShader,fragmentShader:Bi.backgroundCube.fragmentShader,side:kn,depthTest:!1,depthWrite:!1,fog:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(U,C,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),Ys.copy(b.backgroundRotation),Ys.x*=-1,Ys.y*=-1,Ys.z*=-1,y.isCubeTexture&&y.isRenderTargetTexture===!1&&(Ys.y*=-1,Ys.z*=-1),h.material.uniforms.envMap.value=y,h.material.uniforms.flipEnvMap.value=y.isCubeTexture&&y.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(wS.makeRotationFromEuler(Ys)),h.material.toneMapped=le.getTransfer(y.colorSpace)!==Ee,(u!==y||f!==y.version||p!==i.toneMapping)&&(h.material.needsUpdate=!0,u=y,f=y.version,p=i.toneMapping),h.layers.enableAll(),M.unshift(h,h.geometry,h.material,0,0,null)):y&&y.isTexture&&(c===void 0&&(c=new Le(new ao(2,2),new Ti({name:"BackgroundMaterial",uniforms:oo(Bi.background.uniforms),vertexShader:Bi.background.vertexShader,fragmentShader:Bi.background.fragmentShader,side:As,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=y,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.toneMapped=le.getTransfer(y.colorSpace)!==Ee,y.matrixAutoUpdate===!0&&y.updateMatrix(),c.material.uniforms.uvTransform.value.copy(y.matrix),(u!==y||f!==y.version||p!==i.toneMapping)&&(c.material.needsUpdate=!0,u=y,f=y.version,p=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function d(M,b){M.getRGB(ol,Ag(i)),n.buffers.color.setClear(ol.r,ol.g,ol.b,b,o)}return{getClearColor:function(){return a},setClearColor:function(M,b=1){a.set(M),l=b,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(M){l=M,d(a,l)},render:x,addToRenderList:m}}function AS(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(S,R,G,F,W){let J=!1,K=u(F,G,R);r!==K&&(r=K,c(r.object)),J=p(S,F,G,W),J&&g(S,F,G,W),W!==null&&t.update(W,i.ELEMENT_ARRAY_BUFFER),(J||o)&&(o=!1,y(S,R,G,F),W!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(W).buffer))}function l(){return i.createVertexArray()}function c(S){return i.bindVertexArray(S)}function h(S){return i.deleteVertexArray(S)}function u(S,R,G){let F=G.wireframe===!0,W=n[S.id];W===void 0&&(W={},n[S.id]=W);let J=W[R.id];J===void 0&&(J={},W[R.id]=J);let K=J[F];return K===void 0&&(K=f(l()),J[F]=K),K}function f(S){let R=[],G=[],F=[];for(let W=0;W<e;W++)R[W]=0,G[W]=0,F[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:R,enabledAttributes:G,attributeDivisors:F,object:S,attributes:{},index:null}}function p(S,R,G,F){let W=r.attributes,J=R.attributes,K=0,Q=G.getAttributes();for(let tt in Q)if(Q[tt].location>=0){let ct=W[tt],mt=J[tt];if(mt===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(mt=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(mt=S.instanceColor)),ct===void 0||ct.attribute!==mt||mt&&ct.data!==mt.data)return!0;K++}return r.attributesNum!==K||r.index!==F}function g(S,R,G,F){let W={},J=R.attributes,K=0,Q=G.getAttributes();for(let tt in Q)if(Q[tt].location>=0){let ct=J[tt];ct===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(ct=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(ct=S.instanceColor));let mt={};mt.attribute=ct,ct&&ct.data&&(mt.data=ct.data),W[tt]=mt,K++}r.attributes=W,r.attributesNum=K,r.index=F}function x(){let S=r.newAttributes;for(let R=0,G=S.length;R<G;R++)S[R]=0}function m(S){d(S,0)}function d(S,R){let G=r.newAttributes,F=r.enabledAttributes,W=r.attributeDivisors;G[S]=1,F[S]===0&&(i.enableVertexAttribArray(S),F[S]=1),W[S]!==R&&(i.vertexAttribDivisor(S,R),W[S]=R)}function M(){let S=r.newAttributes,R=r.enabledAttributes;for(let G=0,F=R.length;G<F;G++)R[G]!==S[G]&&(i.disableVertexAttribArray(G),R[G]=0)}function b(S,R,G,F,W,J,K){K===!0?i.vertexAttribIPointer(S,R,G,W,J):i.vertexAttribPointer(S,R,G,F,W,J)}function y(S,R,G,F){x();let W=F.attributes,J=G.getAttributes(),K=R.defaultAttributeValues;for(let Q in J){let tt=J[Q];if(tt.location>=0){let ut=W[Q];if(ut===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(ut=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(ut=S.instanceColor)),ut!==void 0){let ct=ut.normalized,mt=ut.itemSize,vt=t.get(ut);if(vt===void 0)continue;let pt=vt.buffer,it=vt.type,at=vt.bytesPerElement,gt=it===i.INT||it===i.UNSIGNED_INT||ut.gpuType===cf;if(ut.isInterleavedBufferAttribute){let ot=ut.data,Bt=ot.stride,Ht=ut.offset;if(ot.isInstancedInterleavedBuffer){for(let Ut=0;Ut<tt.locationSize;Ut++)d(tt.location+Ut,ot.meshPerAttribute);S.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let Ut=0;Ut<tt.locationSize;Ut++)m(tt.location+Ut);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let Ut=0;Ut<tt.locationSize;Ut++)b(tt.location+Ut,mt/tt.locationSize,it,ct,Bt*at,(Ht+mt/tt.locationSize*Ut)*at,gt)}else{if(ut.isInstancedBufferAttribute){for(let ot=0;ot<tt.locationSize;ot++)d(tt.location+ot,ut.meshPerAttribute);S.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=ut.meshPerAttribute*ut.count)}else for(let ot=0;ot<tt.locationSize;ot++)m(tt.location+ot);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let ot=0;ot<tt.locationSize;ot++)b(tt.location+ot,mt/tt.locationSize,it,ct,mt*at,mt/tt.locationSize*ot*at,gt)}}else if(K!==void 0){let ct=K[Q];if(ct!==void 0)switch(ct.length){case 2:i.vertexAttrib2fv(tt.location,ct);break;case 3:i.vertexAttrib3fv(tt.location,ct);break;case 4:i.vertexAttrib4fv(tt.location,ct);break;default:i.vertexAttrib1fv(tt.location,ct)}}}}M()}function U(){O();for(let S in n){let R=n[S];for(let G in R){let F=R[G];for(let W in F)h(F[W].object),delete F[W];delete R[G]}delete n[S]}}function C(S){if(n[S.id]===void 0)return;let R=n[S.id];for(let G in R){let F=R[G];for(let W in F)h(F[W].object),delete F[W];delete R[G]}delete n[S.id]}function D(S){for(let R in n){let G=n[R];if(G[S.id]===void 0)continue;let F=G[S.id];for(let W in F)h(F[W].object),delete F[W];delete G[S.id]}}function O(){A(),o=!0,r!==s&&(r=s,c(r.object))}function A(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:A,dispose:U,releaseStatesOfGeometry:C,releaseStatesOfProgram:D,initAttributes:x,enableAttribute:m,disableUnusedAttributes:M}}function TS(i,t,e){let n;function s(c){n=c}function r(c,h){i.drawArrays(n,c,h),e.update(h,n,1)}function o(c,h,u){u!==0&&(i.drawArraysInstanced(n,c,h,u),e.update(h,n,u))}function a(c,h,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,u);let p=0;for(let g=0;g<u;g++)p+=h[g];e.update(p,n,1)}function l(c,h,u,f){if(u===0)return;let p=t.get("WEBGL_multi_draw");if(p===null)for(let g=0;g<c.length;g++)o(c[g],h[g],f[g]);else{p.multiDrawArraysInstancedWEBGL(n,c,0,h,0,f,0,u);let g=0;for(let x=0;x<u;x++)g+=h[x]*f[x];e.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function CS(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let D=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==Si&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){let O=D===jo&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==rs&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==ns&&!O)}function l(D){if(D==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.logarithmicDepthBuffer===!0,f=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),b=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),U=g>0,C=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reverseDepthBuffer:f,maxTextures:p,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:m,maxAttributes:d,maxVertexUniforms:M,maxVaryings:b,maxFragmentUniforms:y,vertexTextures:U,maxSamples:C}}function RS(i){let t=this,e=null,n=0,s=!1,r=!1,o=new Mi,a=new jt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let p=u.length!==0||f||n!==0||s;return s=f,n=u.length,p},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,p){let g=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,d=i.get(u);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let M=r?0:n,b=M*4,y=d.clippingState||null;l.value=y,y=h(g,f,b,p);for(let U=0;U!==b;++U)y[U]=e[U];d.clippingState=y,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,f,p,g){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=l.value,g!==!0||m===null){let d=p+x*4,M=f.matrixWorldInverse;a.getNormalMatrix(M),(m===null||m.length<d)&&(m=new Float32Array(d));for(let b=0,y=p;b!==x;++b,y+=4)o.copy(u[b]).applyMatrix4(M,a),o.normal.toArray(m,y),m[y+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}function PS(i){let t=new WeakMap;function e(o,a){return a===eu?o.mapping=to:a===nu&&(o.mapping=eo),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===eu||a===nu)if(t.has(o)){let l=t.get(o).texture;return e(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new Ou(l.height);return c.fromEquirectangularTexture(i,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}var Fu=class extends Al{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},$r=4,Nm=[.125,.215,.35,.446,.526,.582],Js=20,Bh=new Fu,Om=new se,zh=null,Vh=0,Hh=0,Gh=!1,Zs=(1+Math.sqrt(5))/2,qr=1/Zs,Fm=[new L(-Zs,qr,0),new L(Zs,qr,0),new L(-qr,0,Zs),new L(qr,0,Zs),new L(0,Zs,-qr),new L(0,Zs,qr),new L(-1,1,-1),new L(1,1,-1),new L(-1,1,1),new L(1,1,1)],Rl=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100){zh=this._renderer.getRenderTarget(),Vh=this._renderer.getActiveCubeFace(),Hh=this._renderer.getActiveMipmapLevel(),Gh=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);let r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(t,n,s,r),e>0&&this._blur(r,0,0,e),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=zm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Bm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(zh,Vh,Hh),this._renderer.xr.enabled=Gh,t.scissorTest=!1,al(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===to||t.mapping===eo?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),zh=this._renderer.getRenderTarget(),Vh=this._renderer.getActiveCubeFace(),Hh=this._renderer.getActiveMipmapLevel(),Gh=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:zi,minFilter:zi,generateMipmaps:!1,type:jo,format:Si,colorSpace:co,depthBuffer:!1},s=km(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=km(t,e,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=IS(r)),this._blurMaterial=LS(r,t,e)}return s}_compileMaterial(t){let e=new Le(this._lodPlanes[0],t);this._renderer.compile(e,Bh)}_sceneToCubeUV(t,e,n,s){let a=new Un(90,1,e,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],h=this._renderer,u=h.autoClear,f=h.toneMapping;h.getClearColor(Om),h.toneMapping=Es,h.autoClear=!1;let p=new Sl({name:"PMREM.Background",side:kn,depthWrite:!1,depthTest:!1}),g=new Le(new jn,p),x=!1,m=t.background;m?m.isColor&&(p.color.copy(m),t.background=null,x=!0):(p.color.copy(Om),x=!0);for(let d=0;d<6;d++){let M=d%3;M===0?(a.up.set(0,l[d],0),a.lookAt(c[d],0,0)):M===1?(a.up.set(0,0,l[d]),a.lookAt(0,c[d],0)):(a.up.set(0,l[d],0),a.lookAt(0,0,c[d]));let b=this._cubeSize;al(s,M*b,d>2?b:0,b,b),h.setRenderTarget(s),x&&h.render(g,a),h.render(t,a)}g.geometry.dispose(),g.material.dispose(),h.toneMapping=f,h.autoClear=u,t.background=m}_textureToCubeUV(t,e){let n=this._renderer,s=t.mapping===to||t.mapping===eo;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=zm()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Bm());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new Le(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;let l=this._cubeSize;al(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(o,Bh)}_applyPMREM(t){let e=this._renderer,n=e.autoClear;e.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Fm[(s-r-1)%Fm.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"longitudinal",r)}_halfBlur(t,e,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let h=3,u=new Le(this._lodPlanes[s],c),f=c.uniforms,p=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*p):2*Math.PI/(2*Js-1),x=r/g,m=isFinite(r)?1+Math.floor(h*x):Js;m>Js&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Js}`);let d=[],M=0;for(let D=0;D<Js;++D){let O=D/x,A=Math.exp(-O*O/2);d.push(A),D===0?M+=A:D<m&&(M+=2*A)}for(let D=0;D<d.length;D++)d[D]=d[D]/M;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:b}=this;f.dTheta.value=g,f.mipInt.value=b-n;let y=this._sizeLods[s],U=3*y*(s>b-$r?s-b+$r:0),C=4*(this._cubeSize-y);al(e,U,C,3*y,2*y),l.setRenderTarget(e),l.render(u,Bh)}};function IS(i){let t=[],e=[],n=[],s=i,r=i-$r+1+Nm.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>i-$r?l=Nm[o-i+$r-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),h=-c,u=1+c,f=[h,h,u,h,u,u,h,h,u,u,h,u],p=6,g=6,x=3,m=2,d=1,M=new Float32Array(x*g*p),b=new Float32Array(m*g*p),y=new Float32Array(d*g*p);for(let C=0;C<p;C++){let D=C%3*2/3-1,O=C>2?0:-1,A=[D,O,0,D+2/3,O,0,D+2/3,O+1,0,D,O,0,D+2/3,O+1,0,D,O+1,0];M.set(A,x*g*C),b.set(f,m*g*C);let S=[C,C,C,C,C,C];y.set(S,d*g*C)}let U=new nn;U.setAttribute("position",new Ke(M,x)),U.setAttribute("uv",new Ke(b,m)),U.setAttribute("faceIndex",new Ke(y,d)),t.push(U),s>$r&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function km(i,t,e){let n=new as(i,t,e);return n.texture.mapping=kl,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function al(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function LS(i,t,e){let n=new Float32Array(Js),s=new L(0,1,0);return new Ti({name:"SphericalGaussianBlur",defines:{n:Js,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:gf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:ws,depthTest:!1,depthWrite:!1})}function Bm(){return new Ti({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:gf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:ws,depthTest:!1,depthWrite:!1})}function zm(){return new Ti({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:gf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:ws,depthTest:!1,depthWrite:!1})}function gf(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function DS(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===eu||l===nu,h=l===to||l===eo;if(c||h){let u=t.get(a),f=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new Rl(i)),u=c?e.fromEquirectangular(a,u):e.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),u.texture;if(u!==void 0)return u.texture;{let p=a.image;return c&&p&&p.height>0||h&&p&&s(p)?(e===null&&(e=new Rl(i)),u=c?e.fromEquirectangular(a):e.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,t.set(a,u),a.addEventListener("dispose",r),u.texture):null}}}return a}function s(a){let l=0,c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function US(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Ho("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function NS(i,t,e,n){let s={},r=new WeakMap;function o(u){let f=u.target;f.index!==null&&t.remove(f.index);for(let g in f.attributes)t.remove(f.attributes[g]);for(let g in f.morphAttributes){let x=f.morphAttributes[g];for(let m=0,d=x.length;m<d;m++)t.remove(x[m])}f.removeEventListener("dispose",o),delete s[f.id];let p=r.get(f);p&&(t.remove(p),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(u,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(u){let f=u.attributes;for(let g in f)t.update(f[g],i.ARRAY_BUFFER);let p=u.morphAttributes;for(let g in p){let x=p[g];for(let m=0,d=x.length;m<d;m++)t.update(x[m],i.ARRAY_BUFFER)}}function c(u){let f=[],p=u.index,g=u.attributes.position,x=0;if(p!==null){let M=p.array;x=p.version;for(let b=0,y=M.length;b<y;b+=3){let U=M[b+0],C=M[b+1],D=M[b+2];f.push(U,C,C,D,D,U)}}else if(g!==void 0){let M=g.array;x=g.version;for(let b=0,y=M.length/3-1;b<y;b+=3){let U=b+0,C=b+1,D=b+2;f.push(U,C,C,D,D,U)}}else return;let m=new(wg(f)?El:wl)(f,1);m.version=x;let d=r.get(u);d&&t.remove(d),r.set(u,m)}function h(u){let f=r.get(u);if(f){let p=u.index;p!==null&&f.version<p.version&&c(u)}else c(u);return r.get(u)}return{get:a,update:l,getWireframeAttribute:h}}function OS(i,t,e){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,p){i.drawElements(n,p,r,f*o),e.update(p,n,1)}function c(f,p,g){g!==0&&(i.drawElementsInstanced(n,p,r,f*o,g),e.update(p,n,g))}function h(f,p,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,p,0,r,f,0,g);let m=0;for(let d=0;d<g;d++)m+=p[d];e.update(m,n,1)}function u(f,p,g,x){if(g===0)return;let m=t.get("WEBGL_multi_draw");if(m===null)for(let d=0;d<f.length;d++)c(f[d]/o,p[d],x[d]);else{m.multiDrawElementsInstancedWEBGL(n,p,0,r,f,0,x,0,g);let d=0;for(let M=0;M<g;M++)d+=p[M]*x[M];e.update(d,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function FS(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function kS(i,t,e){let n=new WeakMap,s=new Ve;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(a);if(f===void 0||f.count!==u){let A=function(){D.dispose(),n.delete(a),a.removeEventListener("dispose",A)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],M=a.morphAttributes.color||[],b=0;p===!0&&(b=1),g===!0&&(b=2),x===!0&&(b=3);let y=a.attributes.position.count*b,U=1;y>t.maxTextureSize&&(U=Math.ceil(y/t.maxTextureSize),y=t.maxTextureSize);let C=new Float32Array(y*U*4*u),D=new Ml(C,y,U,u);D.type=ns,D.needsUpdate=!0;let O=b*4;for(let S=0;S<u;S++){let R=m[S],G=d[S],F=M[S],W=y*U*4*S;for(let J=0;J<R.count;J++){let K=J*O;p===!0&&(s.fromBufferAttribute(R,J),C[W+K+0]=s.x,C[W+K+1]=s.y,C[W+K+2]=s.z,C[W+K+3]=0),g===!0&&(s.fromBufferAttribute(G,J),C[W+K+4]=s.x,C[W+K+5]=s.y,C[W+K+6]=s.z,C[W+K+7]=0),x===!0&&(s.fromBufferAttribute(F,J),C[W+K+8]=s.x,C[W+K+9]=s.y,C[W+K+10]=s.z,C[W+K+11]=F.itemSize===4?s.w:1)}}f={count:u,texture:D,size:new Qt(y,U)},n.set(a,f),a.addEventListener("dispose",A)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let p=0;for(let x=0;x<c.length;x++)p+=c[x];let g=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function BS(i,t,e,n){let s=new WeakMap;function r(l){let c=n.render.frame,h=l.geometry,u=t.get(l,h);if(s.get(u)!==c&&(t.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return u}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}var Pl=class extends Sn{constructor(t,e,n,s,r,o,a,l,c,h=Kr){if(h!==Kr&&h!==io)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&h===Kr&&(n=tr),n===void 0&&h===io&&(n=no),super(null,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:wi,this.minFilter=l!==void 0?l:wi,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}},Cg=new Sn,Vm=new Pl(1,1),Rg=new Ml,Pg=new Uu,Ig=new Tl,Hm=[],Gm=[],Wm=new Float32Array(16),Xm=new Float32Array(9),qm=new Float32Array(4);function uo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Hm[s];if(r===void 0&&(r=new Float32Array(s),Hm[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function sn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function rn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function zl(i,t){let e=Gm[t];e===void 0&&(e=new Int32Array(t),Gm[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function zS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function VS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(sn(e,t))return;i.uniform2fv(this.addr,t),rn(e,t)}}function HS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(sn(e,t))return;i.uniform3fv(this.addr,t),rn(e,t)}}function GS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(sn(e,t))return;i.uniform4fv(this.addr,t),rn(e,t)}}function WS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(sn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),rn(e,t)}else{if(sn(e,n))return;qm.set(n),i.uniformMatrix2fv(this.addr,!1,qm),rn(e,n)}}function XS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(sn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),rn(e,t)}else{if(sn(e,n))return;Xm.set(n),i.uniformMatrix3fv(this.addr,!1,Xm),rn(e,n)}}function qS(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(sn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),rn(e,t)}else{if(sn(e,n))return;Wm.set(n),i.uniformMatrix4fv(this.addr,!1,Wm),rn(e,n)}}function YS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function $S(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(sn(e,t))return;i.uniform2iv(this.addr,t),rn(e,t)}}function ZS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(sn(e,t))return;i.uniform3iv(this.addr,t),rn(e,t)}}function KS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(sn(e,t))return;i.uniform4iv(this.addr,t),rn(e,t)}}function JS(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function jS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(sn(e,t))return;i.uniform2uiv(this.addr,t),rn(e,t)}}function QS(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(sn(e,t))return;i.uniform3uiv(this.addr,t),rn(e,t)}}function tw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(sn(e,t))return;i.uniform4uiv(this.addr,t),rn(e,t)}}function ew(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(Vm.compareFunction=bg,r=Vm):r=Cg,e.setTexture2D(t||r,s)}function nw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Pg,s)}function iw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||Ig,s)}function sw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Rg,s)}function rw(i){switch(i){case 5126:return zS;case 35664:return VS;case 35665:return HS;case 35666:return GS;case 35674:return WS;case 35675:return XS;case 35676:return qS;case 5124:case 35670:return YS;case 35667:case 35671:return $S;case 35668:case 35672:return ZS;case 35669:case 35673:return KS;case 5125:return JS;case 36294:return jS;case 36295:return QS;case 36296:return tw;case 35678:case 36198:case 36298:case 36306:case 35682:return ew;case 35679:case 36299:case 36307:return nw;case 35680:case 36300:case 36308:case 36293:return iw;case 36289:case 36303:case 36311:case 36292:return sw}}function ow(i,t){i.uniform1fv(this.addr,t)}function aw(i,t){let e=uo(t,this.size,2);i.uniform2fv(this.addr,e)}function lw(i,t){let e=uo(t,this.size,3);i.uniform3fv(this.addr,e)}function cw(i,t){let e=uo(t,this.size,4);i.uniform4fv(this.addr,e)}function hw(i,t){let e=uo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function uw(i,t){let e=uo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function fw(i,t){let e=uo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function dw(i,t){i.uniform1iv(this.addr,t)}function pw(i,t){i.uniform2iv(this.addr,t)}function mw(i,t){i.uniform3iv(this.addr,t)}function gw(i,t){i.uniform4iv(this.addr,t)}function _w(i,t){i.uniform1uiv(this.addr,t)}function xw(i,t){i.uniform2uiv(this.addr,t)}function yw(i,t){i.uniform3uiv(this.addr,t)}function vw(i,t){i.uniform4uiv(this.addr,t)}function Mw(i,t,e){let n=this.cache,s=t.length,r=zl(e,s);sn(n,r)||(i.uniform1iv(this.addr,r),rn(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||Cg,r[o])}function bw(i,t,e){let n=this.cache,s=t.length,r=zl(e,s);sn(n,r)||(i.uniform1iv(this.addr,r),rn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Pg,r[o])}function Sw(i,t,e){let n=this.cache,s=t.length,r=zl(e,s);sn(n,r)||(i.uniform1iv(this.addr,r),rn(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||Ig,r[o])}function ww(i,t,e){let n=this.cache,s=t.length,r=zl(e,s);sn(n,r)||(i.uniform1iv(this.addr,r),rn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Rg,r[o])}function Ew(i){switch(i){case 5126:return ow;case 35664:return aw;case 35665:return lw;case 35666:return cw;case 35674:return hw;case 35675:return uw;case 35676:return fw;case 5124:case 35670:return dw;case 35667:case 35671:return pw;case 35668:case 35672:return mw;case 35669:case 35673:return gw;case 5125:return _w;case 36294:return xw;case 36295:return yw;case 36296:return vw;case 35678:case 36198:case 36298:case 36306:case 35682:return Mw;case 35679:case 36299:case 36307:return bw;case 35680:case 36300:case 36308:case 36293:return Sw;case 36289:case 36303:case 36311:case 36292:return ww}}var ku=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=rw(e.type)}},Bu=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Ew(e.type)}},zu=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Wh=/(\w+)(\])?(\[|\.)?/g;function Ym(i,t){i.seq.push(t),i.map[t.id]=t}function Aw(i,t,e){let n=i.name,s=n.length;for(Wh.lastIndex=0;;){let r=Wh.exec(n),o=Wh.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Ym(e,c===void 0?new ku(a,i,t):new Bu(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new zu(a),Ym(e,u)),e=u}}}var jr=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);Aw(r,o,this)}}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function $m(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var Tw=37297,Cw=0;function Rw(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Zm=new jt;function Pw(i){le._getMatrix(Zm,le.workingColorSpace,i);let t=`mat3( ${Zm.elements.map(e=>e.toFixed(4))} )`;switch(le.getTransfer(i)){case Bl:return[t,"LinearTransferOETF"];case Ee:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Km(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),s=i.getShaderInfoLog(t).trim();if(n&&s==="")return"";let r=/ERROR: 0:(\d+)/.exec(s);if(r){let o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+Rw(i.getShaderSource(t),o)}else return s}function Iw(i,t){let e=Pw(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function Lw(i,t){let e;switch(t){case Vy:e="Linear";break;case Hy:e="Reinhard";break;case Gy:e="Cineon";break;case Wy:e="ACESFilmic";break;case qy:e="AgX";break;case Yy:e="Neutral";break;case Xy:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ll=new L;function Dw(){le.getLuminanceCoefficients(ll);let i=ll.x.toFixed(4),t=ll.y.toFixed(4),e=ll.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Uw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Go).join(`
`)}function Nw(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Ow(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Go(i){return i!==""}function Jm(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function jm(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Fw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Vu(i){return i.replace(Fw,Bw)}var kw=new Map;function Bw(i,t){let e=ne[t];if(e===void 0){let n=kw.get(t);if(n!==void 0)e=ne[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return Vu(e)}var zw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Qm(i){return i.replace(zw,Vw)}function Vw(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function tg(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function Hw(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===cg?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===vy?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===es&&(t="SHADOWMAP_TYPE_VSM"),t}function Gw(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case to:case eo:t="ENVMAP_TYPE_CUBE";break;case kl:t="ENVMAP_TYPE_CUBE_UV";break}return t}function Ww(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case eo:t="ENVMAP_MODE_REFRACTION";break}return t}function Xw(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case hg:t="ENVMAP_BLENDING_MULTIPLY";break;case By:t="ENVMAP_BLENDING_MIX";break;case zy:t="ENVMAP_BLENDING_ADD";break}return t}function qw(i){let t=i.envMapCubeUVHeight;if(t===null)return null;let e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),7*16)),texelHeight:n,maxMip:e}}function Yw(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Hw(e),c=Gw(e),h=Ww(e),u=Xw(e),f=qw(e),p=Uw(e),g=Nw(r),x=s.createProgram(),m,d,M=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Go).join(`
`),m.length>0&&(m+=`
`),d=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(Go).join(`
`),d.length>0&&(d+=`
`)):(m=[tg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Go).join(`
`),d=[tg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Es?"#define TONE_MAPPING":"",e.toneMapping!==Es?ne.tonemapping_pars_fragment:"",e.toneMapping!==Es?Lw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ne.colorspace_pars_fragment,Iw("linearToOutputTexel",e.outputColorSpace),Dw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Go).join(`
`)),o=Vu(o),o=Jm(o,e),o=jm(o,e),a=Vu(a),a=Jm(a,e),a=jm(a,e),o=Qm(o),a=Qm(a),e.isRawShaderMaterial!==!0&&(M=`#version 300 es
`,m=[p,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,d=["#define varying in",e.glslVersion===$o?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===$o?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let b=M+m+o,y=M+d+a,U=$m(s,s.VERTEX_SHADER,b),C=$m(s,s.FRAGMENT_SHADER,y);s.attachShader(x,U),s.attachShader(x,C),e.index0AttributeName!==void 0?s.bindAttribLocation(x,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(x,0,"position"),s.linkProgram(x);function D(R){if(i.debug.checkShaderErrors){let G=s.getProgramInfoLog(x).trim(),F=s.getShaderInfoLog(U).trim(),W=s.getShaderInfoLog(C).trim(),J=!0,K=!0;if(s.getProgramParameter(x,s.LINK_STATUS)===!1)if(J=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,x,U,C);else{let Q=Km(s,U,"vertex"),tt=Km(s,C,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(x,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+G+`
`+Q+`
`+tt)}else G!==""?console.warn("THREE.WebGLProgram: Program Info Log:",G):(F===""||W==="")&&(K=!1);K&&(R.diagnostics={runnable:J,programLog:G,vertexShader:{log:F,prefix:m},fragmentShader:{log:W,prefix:d}})}s.deleteShader(U),s.deleteShader(C),O=new jr(s,x),A=Ow(s,x)}let O;this.getUniforms=function(){return O===void 0&&D(this),O};let A;this.getAttributes=function(){return A===void 0&&D(this),A};let S=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(x,Tw)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(x),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Cw++,this.cacheKey=t,this.usedTimes=1,this.program=x,this.vertexShader=U,this.fragmentShader=C,this}var $w=0,Hu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){let e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Gu(t),e.set(t,n)),n}},Gu=class{constructor(t){this.id=$w++,this.code=t,this.usedTimes=0}};function Zw(i,t,e,n,s,r,o){let a=new bl,l=new Hu,c=new Set,h=[],u=s.logarithmicDepthBuffer,f=s.vertexTextures,p=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function x(A){return c.add(A),A===0?"uv":`uv${A}`}function m(A,S,R,G,F){let W=G.fog,J=F.geometry,K=A.isMeshStandardMaterial?G.environment:null,Q=(A.isMeshStandardMaterial?e:t).get(A.envMap||K),tt=Q&&Q.mapping===kl?Q.image.height:null,ut=g[A.type];A.precision!==null&&(p=s.getMaxPrecision(A.precision),p!==A.precision&&console.warn("THREE.WebGLProgram.getParameters:",A.precision,"not supported, using",p,"instead."));let ct=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,mt=ct!==void 0?ct.length:0,vt=0;J.morphAttributes.position!==void 0&&(vt=1),J.morphAttributes.normal!==void 0&&(vt=2),J.morphAttributes.color!==void 0&&(vt=3);let pt,it,at,gt;if(ut){let _e=Bi[ut];pt=_e.vertexShader,it=_e.fragmentShader}else pt=A.vertexShader,it=A.fragmentShader,l.update(A),at=l.getVertexShaderID(A),gt=l.getFragmentShaderID(A);let ot=i.getRenderTarget(),Bt=i.state.buffers.depth.getReversed(),Ht=F.isInstancedMesh===!0,Ut=F.isBatchedMesh===!0,ce=!!A.map,Kt=!!A.matcap,he=!!Q,V=!!A.aoMap,Je=!!A.lightMap,te=!!A.bumpMap,ee=!!A.normalMap,Gt=!!A.displacementMap,fe=!!A.emissiveMap,Pt=!!A.metalnessMap,P=!!A.roughnessMap,w=A.anisotropy>0,Z=A.clearcoat>0,j=A.dispersion>0,X=A.iridescence>0,et=A.sheen>0,Mt=A.transmission>0,_t=w&&!!A.anisotropyMap,Et=Z&&!!A.clearcoatMap,Zt=Z&&!!A.clearcoatNormalMap,ft=Z&&!!A.clearcoatRoughnessMap,xt=X&&!!A.iridescenceMap,Nt=X&&!!A.iridescenceThicknessMap,Ft=et&&!!A.sheenColorMap,St=et&&!!A.sheenRoughnessMap,ie=!!A.specularMap,Yt=!!A.specularColorMap,de=!!A.specularIntensityMap,z=Mt&&!!A.transmissionMap,yt=Mt&&!!A.thicknessMap,nt=!!A.gradientMap,rt=!!A.alphaMap,At=A.alphaTest>0,Tt=!!A.alphaHash,Jt=!!A.extensions,Fe=Es;A.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(Fe=i.toneMapping);let an={shaderID:ut,shaderType:A.type,shaderName:A.name,vertexShader:pt,fragmentShader:it,defines:A.defines,customVertexShaderID:at,customFragmentShaderID:gt,isRawShaderMaterial:A.isRawShaderMaterial===!0,glslVersion:A.glslVersion,precision:p,batching:Ut,batchingColor:Ut&&F._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&F.instanceColor!==null,instancingMorph:Ht&&F.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:ot===null?i.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:co,alphaToCoverage:!!A.alphaToCoverage,map:ce,matcap:Kt,envMap:he,envMapMode:he&&Q.mapping,envMapCubeUVHeight:tt,aoMap:V,lightMap:Je,bumpMap:te,normalMap:ee,displacementMap:f&&Gt,emissiveMap:fe,normalMapObjectSpace:ee&&A.normalMapType===jy,normalMapTangentSpace:ee&&A.normalMapType===Jy,metalnessMap:Pt,roughnessMap:P,anisotropy:w,anisotropyMap:_t,clearcoat:Z,clearcoatMap:Et,clearcoatNormalMap:Zt,clearcoatRoughnessMap:ft,dispersion:j,iridescence:X,iridescenceMap:xt,iridescenceThicknessMap:Nt,sheen:et,sheenColorMap:Ft,sheenRoughnessMap:St,specularMap:ie,specularColorMap:Yt,specularIntensityMap:de,transmission:Mt,transmissionMap:z,thicknessMap:yt,gradientMap:nt,opaque:A.transparent===!1&&A.blending===Zr&&A.alphaToCoverage===!1,alphaMap:rt,alphaTest:At,alphaHash:Tt,combine:A.combine,mapUv:ce&&x(A.map.channel),aoMapUv:V&&x(A.aoMap.channel),lightMapUv:Je&&x(A.lightMap.channel),bumpMapUv:te&&x(A.bumpMap.channel),normalMapUv:ee&&x(A.normalMap.channel),displacementMapUv:Gt&&x(A.displacementMap.channel),emissiveMapUv:fe&&x(A.emissiveMap.channel),metalnessMapUv:Pt&&x(A.metalnessMap.channel),roughnessMapUv:P&&x(A.roughnessMap.channel),anisotropyMapUv:_t&&x(A.anisotropyMap.channel),clearcoatMapUv:Et&&x(A.clearcoatMap.channel),clearcoatNormalMapUv:Zt&&x(A.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ft&&x(A.clearcoatRoughnessMap.channel),iridescenceMapUv:xt&&x(A.iridescenceMap.channel),iridescenceThicknessMapUv:Nt&&x(A.iridescenceThicknessMap.channel),sheenColorMapUv:Ft&&x(A.sheenColorMap.channel),sheenRoughnessMapUv:St&&x(A.sheenRoughnessMap.channel),specularMapUv:ie&&x(A.specularMap.channel),specularColorMapUv:Yt&&x(A.specularColorMap.channel),specularIntensityMapUv:de&&x(A.specularIntensityMap.channel),transmissionMapUv:z&&x(A.transmissionMap.channel),thicknessMapUv:yt&&x(A.thicknessMap.channel),alphaMapUv:rt&&x(A.alphaMap.channel),vertexTangents:!!J.attributes.tangent&&(ee||w),vertexColors:A.vertexColors,vertexAlphas:A.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,pointsUvs:F.isPoints===!0&&!!J.attributes.uv&&(ce||rt),fog:!!W,useFog:A.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:A.flatShading===!0,sizeAttenuation:A.sizeAttenuation===!0,logarithmicDepthBuffer:u,reverseDepthBuffer:Bt,skinning:F.isSkinnedMesh===!0,morphTargets:J.morphAttributes.position!==void 0,morphNormals:J.morphAttributes.normal!==void 0,morphColors:J.morphAttributes.color!==void 0,morphTargetsCount:mt,morphTextureStride:vt,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:A.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.shadowMap.type,toneMapping:Fe,decodeVideoTexture:ce&&A.map.isVideoTexture===!0&&le.getTransfer(A.map.colorSpace)===Ee,decodeVideoTextureEmissive:fe&&A.emissiveMap.isVideoTexture===!0&&le.getTransfer(A.emissiveMap.colorSpace)===Ee,premultipliedAlpha:A.premultipliedAlpha,doubleSided:A.side===bi,flipSided:A.side===kn,useDepthPacking:A.depthPacking>=0,depthPacking:A.depthPacking||0,index0AttributeName:A.index0AttributeName,extensionClipCullDistance:Jt&&A.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Jt&&A.extensions.multiDraw===!0||Ut)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:A.customProgramCacheKey()};return an.vertexUv1s=c.has(1),an.vertexUv2s=c.has(2),an.vertexUv3s=c.has(3),c.clear(),an}function d(A){let S=[];if(A.shaderID?S.push(A.shaderID):(S.push(A.customVertexShaderID),S.push(A.customFragmentShaderID)),A.defines!==void 0)for(let R in A.defines)S.push(R),S.push(A.defines[R]);return A.isRawShaderMaterial===!1&&(M(S,A),b(S,A),S.push(i.outputColorSpace)),S.push(A.customProgramCacheKey),S.join()}function M(A,S){A.push(S.precision),A.push(S.outputColorSpace),A.push(S.envMapMode),A.push(S.envMapCubeUVHeight),A.push(S.mapUv),A.push(S.alphaMapUv),A.push(S.lightMapUv),A.push(S.aoMapUv),A.push(S.bumpMapUv),A.push(S.normalMapUv),A.push(S.displacementMapUv),A.push(S.emissiveMapUv),A.push(S.metalnessMapUv),A.push(S.roughnessMapUv),A.push(S.anisotropyMapUv),A.push(S.clearcoatMapUv),A.push(S.clearcoatNormalMapUv),A.push(S.clearcoatRoughnessMapUv),A.push(S.iridescenceMapUv),A.push(S.iridescenceThicknessMapUv),A.push(S.sheenColorMapUv),A.push(S.sheenRoughnessMapUv),A.push(S.specularMapUv),A.push(S.specularColorMapUv),A.push(S.specularIntensityMapUv),A.push(S.transmissionMapUv),A.push(S.thicknessMapUv),A.push(S.combine),A.push(S.fogExp2),A.push(S.sizeAttenuation),A.push(S.morphTargetsCount),A.push(S.morphAttributeCount),A.push(S.numDirLights),A.push(S.numPointLights),A.push(S.numSpotLights),A.push(S.numSpotLightMaps),A.push(S.numHemiLights),A.push(S.numRectAreaLights),A.push(S.numDirLightShadows),A.push(S.numPointLightShadows),A.push(S.numSpotLightShadows),A.push(S.numSpotLightShadowsWithMaps),A.push(S.numLightProbes),A.push(S.shadowMapType),A.push(S.toneMapping),A.push(S.numClippingPlanes),A.push(S.numClipIntersection),A.push(S.depthPacking)}function b(A,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),A.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reverseDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),A.push(a.mask)}function y(A){let S=g[A.type],R;if(S){let G=Bi[S];R=Bv.clone(G.uniforms)}else R=A.uniforms;return R}function U(A,S){let R;for(let G=0,F=h.length;G<F;G++){let W=h[G];if(W.cacheKey===S){R=W,++R.usedTimes;break}}return R===void 0&&(R=new Yw(i,S,A,r),h.push(R)),R}function C(A){if(--A.usedTimes===0){let S=h.indexOf(A);h[S]=h[h.length-1],h.pop(),A.destroy()}}function D(A){l.remove(A)}function O(){l.dispose()}return{getParameters:m,getProgramCacheKey:d,getUniforms:y,acquireProgram:U,releaseProgram:C,releaseShaderCache:D,programs:h,dispose:O}}function Kw(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Jw(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function eg(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function ng(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(u,f,p,g,x,m){let d=i[t];return d===void 0?(d={id:u.id,object:u,geometry:f,material:p,groupOrder:g,renderOrder:u.renderOrder,z:x,group:m},i[t]=d):(d.id=u.id,d.object=u,d.geometry=f,d.material=p,d.groupOrder=g,d.renderOrder=u.renderOrder,d.z=x,d.group=m),t++,d}function a(u,f,p,g,x,m){let d=o(u,f,p,g,x,m);p.transmission>0?n.push(d):p.transparent===!0?s.push(d):e.push(d)}function l(u,f,p,g,x,m){let d=o(u,f,p,g,x,m);p.transmission>0?n.unshift(d):p.transparent===!0?s.unshift(d):e.unshift(d)}function c(u,f){e.length>1&&e.sort(u||Jw),n.length>1&&n.sort(f||eg),s.length>1&&s.sort(f||eg)}function h(){for(let u=t,f=i.length;u<f;u++){let p=i[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function jw(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new ng,i.set(n,[o])):s>=r.length?(o=new ng,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function Qw(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new L,color:new se};break;case"SpotLight":e={position:new L,direction:new L,color:new se,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new L,color:new se,distance:0,decay:0};break;case"HemisphereLight":e={direction:new L,skyColor:new se,groundColor:new se};break;case"RectAreaLight":e={color:new se,position:new L,halfWidth:new L,halfHeight:new L};break}return i[t.id]=e,e}}}function t1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Qt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var e1=0;function n1(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function i1(i){let t=new Qw,e=t1(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new L);let s=new L,r=new He,o=new He;function a(c){let h=0,u=0,f=0;for(let A=0;A<9;A++)n.probe[A].set(0,0,0);let p=0,g=0,x=0,m=0,d=0,M=0,b=0,y=0,U=0,C=0,D=0;c.sort(n1);for(let A=0,S=c.length;A<S;A++){let R=c[A],G=R.color,F=R.intensity,W=R.distance,J=R.shadow&&R.shadow.map?R.shadow.map.texture:null;if(R.isAmbientLight)h+=G.r*F,u+=G.g*F,f+=G.b*F;else if(R.isLightProbe){for(let K=0;K<9;K++)n.probe[K].addScaledVector(R.sh.coefficients[K],F);D++}else if(R.isDirectionalLight){let K=t.get(R);if(K.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let Q=R.shadow,tt=e.get(R);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,n.directionalShadow[p]=tt,n.directionalShadowMap[p]=J,n.directionalShadowMatrix[p]=R.shadow.matrix,M++}n.directional[p]=K,p++}else if(R.isSpotLight){let K=t.get(R);K.position.setFromMatrixPosition(R.matrixWorld),K.color.copy(G).multiplyScalar(F),K.distance=W,K.coneCos=Math.cos(R.angle),K.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),K.decay=R.decay,n.spot[x]=K;let Q=R.shadow;if(R.map&&(n.spotLightMap[U]=R.map,U++,Q.updateMatrices(R),R.castShadow&&C++),n.spotLightMatrix[x]=Q.matrix,R.castShadow){let tt=e.get(R);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,n.spotShadow[x]=tt,n.spotShadowMap[x]=J,y++}x++}else if(R.isRectAreaLight){let K=t.get(R);K.color.copy(G).multiplyScalar(F),K.halfWidth.set(R.width*.5,0,0),K.halfHeight.set(0,R.height*.5,0),n.rectArea[m]=K,m++}else if(R.isPointLight){let K=t.get(R);if(K.color.copy(R.color).multiplyScalar(R.intensity),K.distance=R.distance,K.decay=R.decay,R.castShadow){let Q=R.shadow,tt=e.get(R);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,tt.shadowCameraNear=Q.camera.near,tt.shadowCameraFar=Q.camera.far,n.pointShadow[g]=tt,n.pointShadowMap[g]=J,n.pointShadowMatrix[g]=R.shadow.matrix,b++}n.point[g]=K,g++}else if(R.isHemisphereLight){let K=t.get(R);K.skyColor.copy(R.color).multiplyScalar(F),K.groundColor.copy(R.groundColor).multiplyScalar(F),n.hemi[d]=K,d++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=wt.LTC_FLOAT_1,n.rectAreaLTC2=wt.LTC_FLOAT_2):(n.rectAreaLTC1=wt.LTC_HALF_1,n.rectAreaLTC2=wt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let O=n.hash;(O.directionalLength!==p||O.pointLength!==g||O.spotLength!==x||O.rectAreaLength!==m||O.hemiLength!==d||O.numDirectionalShadows!==M||O.numPointShadows!==b||O.numSpotShadows!==y||O.numSpotMaps!==U||O.numLightProbes!==D)&&(n.directional.length=p,n.spot.length=x,n.rectArea.length=m,n.point.length=g,n.hemi.length=d,n.directionalShadow.length=M,n.directionalShadowMap.length=M,n.pointShadow.length=b,n.pointShadowMap.length=b,n.spotShadow.length=y,n.spotShadowMap.length=y,n.directionalShadowMatrix.length=M,n.pointShadowMatrix.length=b,n.spotLightMatrix.length=y+U-C,n.spotLightMap.length=U,n.numSpotLightShadowsWithMaps=C,n.numLightProbes=D,O.directionalLength=p,O.pointLength=g,O.spotLength=x,O.rectAreaLength=m,O.hemiLength=d,O.numDirectionalShadows=M,O.numPointShadows=b,O.numSpotShadows=y,O.numSpotMaps=U,O.numLightProbes=D,n.version=e1++)}function l(c,h){let u=0,f=0,p=0,g=0,x=0,m=h.matrixWorldInverse;for(let d=0,M=c.length;d<M;d++){let b=c[d];if(b.isDirectionalLight){let y=n.directional[u];y.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(m),u++}else if(b.isSpotLight){let y=n.spot[p];y.position.setFromMatrixPosition(b.matrixWorld),y.position.applyMatrix4(m),y.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let y=n.rectArea[g];y.position.setFromMatrixPosition(b.matrixWorld),y.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),y.halfWidth.set(b.width*.5,0,0),y.halfHeight.set(0,b.height*.5,0),y.halfWidth.applyMatrix4(o),y.halfHeight.applyMatrix4(o),g++}else if(b.isPointLight){let y=n.point[f];y.position.setFromMatrixPosition(b.matrixWorld),y.position.applyMatrix4(m),f++}else if(b.isHemisphereLight){let y=n.hemi[x];y.direction.setFromMatrixPosition(b.matrixWorld),y.direction.transformDirection(m),x++}}}return{setup:a,setupView:l,state:n}}function ig(i){let t=new i1(i),e=[],n=[];function s(h){c.camera=h,e.length=0,n.length=0}function r(h){e.push(h)}function o(h){n.push(h)}function a(){t.setup(e)}function l(h){t.setupView(e,h)}let c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function s1(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new ig(i),t.set(s,[a])):r>=o.length?(a=new ig(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var Wu=class extends er{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=Zy,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Xu=class extends er{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}},r1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,o1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function a1(i,t,e){let n=new Cl,s=new Qt,r=new Qt,o=new Ve,a=new Wu({depthPacking:Ky}),l=new Xu,c={},h=e.maxTextureSize,u={[As]:kn,[kn]:As,[bi]:bi},f=new Ti({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Qt},radius:{value:4}},vertexShader:r1,fragmentShader:o1}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let g=new nn;g.setAttribute("position",new Ke(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Le(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=cg;let d=this.type;this.render=function(C,D,O){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||C.length===0)return;let A=i.getRenderTarget(),S=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),G=i.state;G.setBlending(ws),G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let F=d!==es&&this.type===es,W=d===es&&this.type!==es;for(let J=0,K=C.length;J<K;J++){let Q=C[J],tt=Q.shadow;if(tt===void 0){console.warn("THREE.WebGLShadowMap:",Q,"has no shadow.");continue}if(tt.autoUpdate===!1&&tt.needsUpdate===!1)continue;s.copy(tt.mapSize);let ut=tt.getFrameExtents();if(s.multiply(ut),r.copy(tt.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ut.x),s.x=r.x*ut.x,tt.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ut.y),s.y=r.y*ut.y,tt.mapSize.y=r.y)),tt.map===null||F===!0||W===!0){let mt=this.type!==es?{minFilter:wi,magFilter:wi}:{};tt.map!==null&&tt.map.dispose(),tt.map=new as(s.x,s.y,mt),tt.map.texture.name=Q.name+".shadowMap",tt.camera.updateProjectionMatrix()}i.setRenderTarget(tt.map),i.clear();let ct=tt.getViewportCount();for(let mt=0;mt<ct;mt++){let vt=tt.getViewport(mt);o.set(r.x*vt.x,r.y*vt.y,r.x*vt.z,r.y*vt.w),G.viewport(o),tt.updateMatrices(Q,mt),n=tt.getFrustum(),y(D,O,tt.camera,Q,this.type)}tt.isPointLightShadow!==!0&&this.type===es&&M(tt,O),tt.needsUpdate=!1}d=this.type,m.needsUpdate=!1,i.setRenderTarget(A,S,R)};function M(C,D){let O=t.update(x);f.defines.VSM_SAMPLES!==C.blurSamples&&(f.defines.VSM_SAMPLES=C.blurSamples,p.defines.VSM_SAMPLES=C.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),C.mapPass===null&&(C.mapPass=new as(s.x,s.y)),f.uniforms.shadow_pass.value=C.map.texture,f.uniforms.resolution.value=C.mapSize,f.uniforms.radius.value=C.radius,i.setRenderTarget(C.mapPass),i.clear(),i.renderBufferDirect(D,null,O,f,x,null),p.uniforms.shadow_pass.value=C.mapPass.texture,p.uniforms.resolution.value=C.mapSize,p.uniforms.radius.value=C.radius,i.setRenderTarget(C.map),i.clear(),i.renderBufferDirect(D,null,O,p,x,null)}function b(C,D,O,A){let S=null,R=O.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(R!==void 0)S=R;else if(S=O.isPointLight===!0?l:a,i.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){let G=S.uuid,F=D.uuid,W=c[G];W===void 0&&(W={},c[G]=W);let J=W[F];J===void 0&&(J=S.clone(),W[F]=J,D.addEventListener("dispose",U)),S=J}if(S.visible=D.visible,S.wireframe=D.wireframe,A===es?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:u[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,O.isPointLight===!0&&S.isMeshDistanceMaterial===!0){let G=i.properties.get(S);G.light=O}return S}function y(C,D,O,A,S){if(C.visible===!1)return;if(C.layers.test(D.layers)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&S===es)&&(!C.frustumCulled||n.intersectsObject(C))){C.modelViewMatrix.multiplyMatrices(O.matrixWorldInverse,C.matrixWorld);let F=t.update(C),W=C.material;if(Array.isArray(W)){let J=F.groups;for(let K=0,Q=J.length;K<Q;K++){let tt=J[K],ut=W[tt.materialIndex];if(ut&&ut.visible){let ct=b(C,ut,A,S);C.onBeforeShadow(i,C,D,O,F,ct,tt),i.renderBufferDirect(O,null,F,ct,C,tt),C.onAfterShadow(i,C,D,O,F,ct,tt)}}}else if(W.visible){let J=b(C,W,A,S);C.onBeforeShadow(i,C,D,O,F,J,null),i.renderBufferDirect(O,null,F,J,C,null),C.onAfterShadow(i,C,D,O,F,J,null)}}let G=C.children;for(let F=0,W=G.length;F<W;F++)y(G[F],D,O,A,S)}function U(C){C.target.removeEventListener("dispose",U);for(let O in c){let A=c[O],S=C.target.uuid;S in A&&(A[S].dispose(),delete A[S])}}}var l1={[$h]:Zh,[Kh]:Qh,[Jh]:tu,[Qr]:jh,[Zh]:$h,[Qh]:Kh,[tu]:Jh,[jh]:Qr};function c1(i,t){function e(){let z=!1,yt=new Ve,nt=null,rt=new Ve(0,0,0,0);return{setMask:function(At){nt!==At&&!z&&(i.colorMask(At,At,At,At),nt=At)},setLocked:function(At){z=At},setClear:function(At,Tt,Jt,Fe,an){an===!0&&(At*=Fe,Tt*=Fe,Jt*=Fe),yt.set(At,Tt,Jt,Fe),rt.equals(yt)===!1&&(i.clearColor(At,Tt,Jt,Fe),rt.copy(yt))},reset:function(){z=!1,nt=null,rt.set(-1,0,0,0)}}}function n(){let z=!1,yt=!1,nt=null,rt=null,At=null;return{setReversed:function(Tt){if(yt!==Tt){let Jt=t.get("EXT_clip_control");yt?Jt.clipControlEXT(Jt.LOWER_LEFT_EXT,Jt.ZERO_TO_ONE_EXT):Jt.clipControlEXT(Jt.LOWER_LEFT_EXT,Jt.NEGATIVE_ONE_TO_ONE_EXT);let Fe=At;At=null,this.setClear(Fe)}yt=Tt},getReversed:function(){return yt},setTest:function(Tt){Tt?ot(i.DEPTH_TEST):Bt(i.DEPTH_TEST)},setMask:function(Tt){nt!==Tt&&!z&&(i.depthMask(Tt),nt=Tt)},setFunc:function(Tt){if(yt&&(Tt=l1[Tt]),rt!==Tt){switch(Tt){case $h:i.depthFunc(i.NEVER);break;case Zh:i.depthFunc(i.ALWAYS);break;case Kh:i.depthFunc(i.LESS);break;case Qr:i.depthFunc(i.LEQUAL);break;case Jh:i.depthFunc(i.EQUAL);break;case jh:i.depthFunc(i.GEQUAL);break;case Qh:i.depthFunc(i.GREATER);break;case tu:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}rt=Tt}},setLocked:function(Tt){z=Tt},setClear:function(Tt){At!==Tt&&(yt&&(Tt=1-Tt),i.clearDepth(Tt),At=Tt)},reset:function(){z=!1,nt=null,rt=null,At=null,yt=!1}}}function s(){let z=!1,yt=null,nt=null,rt=null,At=null,Tt=null,Jt=null,Fe=null,an=null;return{setTest:function(_e){z||(_e?ot(i.STENCIL_TEST):Bt(i.STENCIL_TEST))},setMask:function(_e){yt!==_e&&!z&&(i.stencilMask(_e),yt=_e)},setFunc:function(_e,je,Ie){(nt!==_e||rt!==je||At!==Ie)&&(i.stencilFunc(_e,je,Ie),nt=_e,rt=je,At=Ie)},setOp:function(_e,je,Ie){(Tt!==_e||Jt!==je||Fe!==Ie)&&(i.stencilOp(_e,je,Ie),Tt=_e,Jt=je,Fe=Ie)},setLocked:function(_e){z=_e},setClear:function(_e){an!==_e&&(i.clearStencil(_e),an=_e)},reset:function(){z=!1,yt=null,nt=null,rt=null,At=null,Tt=null,Jt=null,Fe=null,an=null}}}let r=new e,o=new n,a=new s,l=new WeakMap,c=new WeakMap,h={},u={},f=new WeakMap,p=[],g=null,x=!1,m=null,d=null,M=null,b=null,y=null,U=null,C=null,D=new se(0,0,0),O=0,A=!1,S=null,R=null,G=null,F=null,W=null,J=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),K=!1,Q=0,tt=i.getParameter(i.VERSION);tt.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(tt)[1]),K=Q>=1):tt.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(tt)[1]),K=Q>=2);let ut=null,ct={},mt=i.getParameter(i.SCISSOR_BOX),vt=i.getParameter(i.VIEWPORT),pt=new Ve().fromArray(mt),it=new Ve().fromArray(vt);function at(z,yt,nt,rt){let At=new Uint8Array(4),Tt=i.createTexture();i.bindTexture(z,Tt),i.texParameteri(z,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(z,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Jt=0;Jt<nt;Jt++)z===i.TEXTURE_3D||z===i.TEXTURE_2D_ARRAY?i.texImage3D(yt,0,i.RGBA,1,1,rt,0,i.RGBA,i.UNSIGNED_BYTE,At):i.texImage2D(yt+Jt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,At);return Tt}let gt={};gt[i.TEXTURE_2D]=at(i.TEXTURE_2D,i.TEXTURE_2D,1),gt[i.TEXTURE_CUBE_MAP]=at(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),gt[i.TEXTURE_2D_ARRAY]=at(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),gt[i.TEXTURE_3D]=at(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ot(i.DEPTH_TEST),o.setFunc(Qr),te(!1),ee(rm),ot(i.CULL_FACE),V(ws);function ot(z){h[z]!==!0&&(i.enable(z),h[z]=!0)}function Bt(z){h[z]!==!1&&(i.disable(z),h[z]=!1)}function Ht(z,yt){return u[z]!==yt?(i.bindFramebuffer(z,yt),u[z]=yt,z===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=yt),z===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=yt),!0):!1}function Ut(z,yt){let nt=p,rt=!1;if(z){nt=f.get(yt),nt===void 0&&(nt=[],f.set(yt,nt));let At=z.textures;if(nt.length!==At.length||nt[0]!==i.COLOR_ATTACHMENT0){for(let Tt=0,Jt=At.length;Tt<Jt;Tt++)nt[Tt]=i.COLOR_ATTACHMENT0+Tt;nt.length=At.length,rt=!0}}else nt[0]!==i.BACK&&(nt[0]=i.BACK,rt=!0);rt&&i.drawBuffers(nt)}function ce(z){return g!==z?(i.useProgram(z),g=z,!0):!1}let Kt={[Ks]:i.FUNC_ADD,[by]:i.FUNC_SUBTRACT,[Sy]:i.FUNC_REVERSE_SUBTRACT};Kt[wy]=i.MIN,Kt[Ey]=i.MAX;let he={[Ay]:i.ZERO,[Ty]:i.ONE,[Cy]:i.SRC_COLOR,[qh]:i.SRC_ALPHA,[Uy]:i.SRC_ALPHA_SATURATE,[Ly]:i.DST_COLOR,[Py]:i.DST_ALPHA,[Ry]:i.ONE_MINUS_SRC_COLOR,[Yh]:i.ONE_MINUS_SRC_ALPHA,[Dy]:i.ONE_MINUS_DST_COLOR,[Iy]:i.ONE_MINUS_DST_ALPHA,[Ny]:i.CONSTANT_COLOR,[Oy]:i.ONE_MINUS_CONSTANT_COLOR,[Fy]:i.CONSTANT_ALPHA,[ky]:i.ONE_MINUS_CONSTANT_ALPHA};function V(z,yt,nt,rt,At,Tt,Jt,Fe,an,_e){if(z===ws){x===!0&&(Bt(i.BLEND),x=!1);return}if(x===!1&&(ot(i.BLEND),x=!0),z!==My){if(z!==m||_e!==A){if((d!==Ks||y!==Ks)&&(i.blendEquation(i.FUNC_ADD),d=Ks,y=Ks),_e)switch(z){case Zr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case om:i.blendFunc(i.ONE,i.ONE);break;case am:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case lm:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",z);break}else switch(z){case Zr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case om:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case am:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case lm:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",z);break}M=null,b=null,U=null,C=null,D.set(0,0,0),O=0,m=z,A=_e}return}At=At||yt,Tt=Tt||nt,Jt=Jt||rt,(yt!==d||At!==y)&&(i.blendEquationSeparate(Kt[yt],Kt[At]),d=yt,y=At),(nt!==M||rt!==b||Tt!==U||Jt!==C)&&(i.blendFuncSeparate(he[nt],he[rt],he[Tt],he[Jt]),M=nt,b=rt,U=Tt,C=Jt),(Fe.equals(D)===!1||an!==O)&&(i.blendColor(Fe.r,Fe.g,Fe.b,an),D.copy(Fe),O=an),m=z,A=!1}function Je(z,yt){z.side===bi?Bt(i.CULL_FACE):ot(i.CULL_FACE);let nt=z.side===kn;yt&&(nt=!nt),te(nt),z.blending===Zr&&z.transparent===!1?V(ws):V(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let rt=z.stencilWrite;a.setTest(rt),rt&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),fe(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?ot(i.SAMPLE_ALPHA_TO_COVERAGE):Bt(i.SAMPLE_ALPHA_TO_COVERAGE)}function te(z){S!==z&&(z?i.frontFace(i.CW):i.frontFace(i.CCW),S=z)}function ee(z){z!==xy?(ot(i.CULL_FACE),z!==R&&(z===rm?i.cullFace(i.BACK):z===yy?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Bt(i.CULL_FACE),R=z}function Gt(z){z!==G&&(K&&i.lineWidth(z),G=z)}function fe(z,yt,nt){z?(ot(i.POLYGON_OFFSET_FILL),(F!==yt||W!==nt)&&(i.polygonOffset(yt,nt),F=yt,W=nt)):Bt(i.POLYGON_OFFSET_FILL)}function Pt(z){z?ot(i.SCISSOR_TEST):Bt(i.SCISSOR_TEST)}function P(z){z===void 0&&(z=i.TEXTURE0+J-1),ut!==z&&(i.activeTexture(z),ut=z)}function w(z,yt,nt){nt===void 0&&(ut===null?nt=i.TEXTURE0+J-1:nt=ut);let rt=ct[nt];rt===void 0&&(rt={type:void 0,texture:void 0},ct[nt]=rt),(rt.type!==z||rt.texture!==yt)&&(ut!==nt&&(i.activeTexture(nt),ut=nt),i.bindTexture(z,yt||gt[z]),rt.type=z,rt.texture=yt)}function Z(){let z=ct[ut];z!==void 0&&z.type!==void 0&&(i.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function j(){try{i.compressedTexImage2D.apply(i,arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function X(){try{i.compressedTexImage3D.apply(i,arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function et(){try{i.texSubImage2D.apply(i,arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function Mt(){try{i.texSubImage3D.apply(i,arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function _t(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function Et(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function Zt(){try{i.texStorage2D.apply(i,arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function ft(){try{i.texStorage3D.apply(i,arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function xt(){try{i.texImage2D.apply(i,arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function Nt(){try{i.texImage3D.apply(i,arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function Ft(z){pt.equals(z)===!1&&(i.scissor(z.x,z.y,z.z,z.w),pt.copy(z))}function St(z){it.equals(z)===!1&&(i.viewport(z.x,z.y,z.z,z.w),it.copy(z))}function ie(z,yt){let nt=c.get(yt);nt===void 0&&(nt=new WeakMap,c.set(yt,nt));let rt=nt.get(z);rt===void 0&&(rt=i.getUniformBlockIndex(yt,z.name),nt.set(z,rt))}function Yt(z,yt){let rt=c.get(yt).get(z);l.get(yt)!==rt&&(i.uniformBlockBinding(yt,rt,z.__bindingPointIndex),l.set(yt,rt))}function de(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},ut=null,ct={},u={},f=new WeakMap,p=[],g=null,x=!1,m=null,d=null,M=null,b=null,y=null,U=null,C=null,D=new se(0,0,0),O=0,A=!1,S=null,R=null,G=null,F=null,W=null,pt.set(0,0,i.canvas.width,i.canvas.height),it.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ot,disable:Bt,bindFramebuffer:Ht,drawBuffers:Ut,useProgram:ce,setBlending:V,setMaterial:Je,setFlipSided:te,setCullFace:ee,setLineWidth:Gt,setPolygonOffset:fe,setScissorTest:Pt,activeTexture:P,bindTexture:w,unbindTexture:Z,compressedTexImage2D:j,compressedTexImage3D:X,texImage2D:xt,texImage3D:Nt,updateUBOMapping:ie,uniformBlockBinding:Yt,texStorage2D:Zt,texStorage3D:ft,texSubImage2D:et,texSubImage3D:Mt,compressedTexSubImage2D:_t,compressedTexSubImage3D:Et,scissor:Ft,viewport:St,reset:de}}function sg(i,t,e,n){let s=h1(n);switch(e){case mg:return i*t;case _g:return i*t;case xg:return i*t*2;case yg:return i*t/s.components*s.byteLength;case ff:return i*t/s.components*s.byteLength;case vg:return i*t*2/s.components*s.byteLength;case df:return i*t*2/s.components*s.byteLength;case gg:return i*t*3/s.components*s.byteLength;case Si:return i*t*4/s.components*s.byteLength;case pf:return i*t*4/s.components*s.byteLength;case fl:case dl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case pl:case ml:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ou:case lu:return Math.max(i,16)*Math.max(t,8)/4;case ru:case au:return Math.max(i,8)*Math.max(t,8)/2;case cu:case hu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case uu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case fu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case du:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case pu:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case mu:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case gu:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case _u:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case xu:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case yu:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case vu:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Mu:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case bu:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Su:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case wu:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Eu:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case gl:case Au:case Tu:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Mg:case Cu:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ru:case Pu:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function h1(i){switch(i){case rs:case fg:return{byteLength:1,components:1};case Yo:case dg:case jo:return{byteLength:2,components:1};case hf:case uf:return{byteLength:2,components:4};case tr:case cf:case ns:return{byteLength:4,components:1};case pg:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function u1(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Qt,h=new WeakMap,u,f=new WeakMap,p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,w){return p?new OffscreenCanvas(P,w):yl("canvas")}function x(P,w,Z){let j=1,X=Pt(P);if((X.width>Z||X.height>Z)&&(j=Z/Math.max(X.width,X.height)),j<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let et=Math.floor(j*X.width),Mt=Math.floor(j*X.height);u===void 0&&(u=g(et,Mt));let _t=w?g(et,Mt):u;return _t.width=et,_t.height=Mt,_t.getContext("2d").drawImage(P,0,0,et,Mt),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+X.width+"x"+X.height+") to ("+et+"x"+Mt+")."),_t}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+X.width+"x"+X.height+")."),P;return P}function m(P){return P.generateMipmaps}function d(P){i.generateMipmap(P)}function M(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function b(P,w,Z,j,X=!1){if(P!==null){if(i[P]!==void 0)return i[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let et=w;if(w===i.RED&&(Z===i.FLOAT&&(et=i.R32F),Z===i.HALF_FLOAT&&(et=i.R16F),Z===i.UNSIGNED_BYTE&&(et=i.R8)),w===i.RED_INTEGER&&(Z===i.UNSIGNED_BYTE&&(et=i.R8UI),Z===i.UNSIGNED_SHORT&&(et=i.R16UI),Z===i.UNSIGNED_INT&&(et=i.R32UI),Z===i.BYTE&&(et=i.R8I),Z===i.SHORT&&(et=i.R16I),Z===i.INT&&(et=i.R32I)),w===i.RG&&(Z===i.FLOAT&&(et=i.RG32F),Z===i.HALF_FLOAT&&(et=i.RG16F),Z===i.UNSIGNED_BYTE&&(et=i.RG8)),w===i.RG_INTEGER&&(Z===i.UNSIGNED_BYTE&&(et=i.RG8UI),Z===i.UNSIGNED_SHORT&&(et=i.RG16UI),Z===i.UNSIGNED_INT&&(et=i.RG32UI),Z===i.BYTE&&(et=i.RG8I),Z===i.SHORT&&(et=i.RG16I),Z===i.INT&&(et=i.RG32I)),w===i.RGB_INTEGER&&(Z===i.UNSIGNED_BYTE&&(et=i.RGB8UI),Z===i.UNSIGNED_SHORT&&(et=i.RGB16UI),Z===i.UNSIGNED_INT&&(et=i.RGB32UI),Z===i.BYTE&&(et=i.RGB8I),Z===i.SHORT&&(et=i.RGB16I),Z===i.INT&&(et=i.RGB32I)),w===i.RGBA_INTEGER&&(Z===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),Z===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),Z===i.UNSIGNED_INT&&(et=i.RGBA32UI),Z===i.BYTE&&(et=i.RGBA8I),Z===i.SHORT&&(et=i.RGBA16I),Z===i.INT&&(et=i.RGBA32I)),w===i.RGB&&Z===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),w===i.RGBA){let Mt=X?Bl:le.getTransfer(j);Z===i.FLOAT&&(et=i.RGBA32F),Z===i.HALF_FLOAT&&(et=i.RGBA16F),Z===i.UNSIGNED_BYTE&&(et=Mt===Ee?i.SRGB8_ALPHA8:i.RGBA8),Z===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),Z===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function y(P,w){let Z;return P?w===null||w===tr||w===no?Z=i.DEPTH24_STENCIL8:w===ns?Z=i.DEPTH32F_STENCIL8:w===Yo&&(Z=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===tr||w===no?Z=i.DEPTH_COMPONENT24:w===ns?Z=i.DEPTH_COMPONENT32F:w===Yo&&(Z=i.DEPTH_COMPONENT16),Z}function U(P,w){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==wi&&P.minFilter!==zi?Math.log2(Math.max(w.width,w.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?w.mipmaps.length:1}function C(P){let w=P.target;w.removeEventListener("dispose",C),O(w),w.isVideoTexture&&h.delete(w)}function D(P){let w=P.target;w.removeEventListener("dispose",D),S(w)}function O(P){let w=n.get(P);if(w.__webglInit===void 0)return;let Z=P.source,j=f.get(Z);if(j){let X=j[w.__cacheKey];X.usedTimes--,X.usedTimes===0&&A(P),Object.keys(j).length===0&&f.delete(Z)}n.remove(P)}function A(P){let w=n.get(P);i.deleteTexture(w.__webglTexture);let Z=P.source,j=f.get(Z);delete j[w.__cacheKey],o.memory.textures--}function S(P){let w=n.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),n.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(w.__webglFramebuffer[j]))for(let X=0;X<w.__webglFramebuffer[j].length;X++)i.deleteFramebuffer(w.__webglFramebuffer[j][X]);else i.deleteFramebuffer(w.__webglFramebuffer[j]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[j])}else{if(Array.isArray(w.__webglFramebuffer))for(let j=0;j<w.__webglFramebuffer.length;j++)i.deleteFramebuffer(w.__webglFramebuffer[j]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let j=0;j<w.__webglColorRenderbuffer.length;j++)w.__webglColorRenderbuffer[j]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[j]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let Z=P.textures;for(let j=0,X=Z.length;j<X;j++){let et=n.get(Z[j]);et.__webglTexture&&(i.deleteTexture(et.__webglTexture),o.memory.textures--),n.remove(Z[j])}n.remove(P)}let R=0;function G(){R=0}function F(){let P=R;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),R+=1,P}function W(P){let w=[];return w.push(P.wrapS),w.push(P.wrapT),w.push(P.wrapR||0),w.push(P.magFilter),w.push(P.minFilter),w.push(P.anisotropy),w.push(P.internalFormat),w.push(P.format),w.push(P.type),w.push(P.generateMipmaps),w.push(P.premultiplyAlpha),w.push(P.flipY),w.push(P.unpackAlignment),w.push(P.colorSpace),w.join()}function J(P,w){let Z=n.get(P);if(P.isVideoTexture&&Gt(P),P.isRenderTargetTexture===!1&&P.version>0&&Z.__version!==P.version){let j=P.image;if(j===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(j.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{it(Z,P,w);return}}e.bindTexture(i.TEXTURE_2D,Z.__webglTexture,i.TEXTURE0+w)}function K(P,w){let Z=n.get(P);if(P.version>0&&Z.__version!==P.version){it(Z,P,w);return}e.bindTexture(i.TEXTURE_2D_ARRAY,Z.__webglTexture,i.TEXTURE0+w)}function Q(P,w){let Z=n.get(P);if(P.version>0&&Z.__version!==P.version){it(Z,P,w);return}e.bindTexture(i.TEXTURE_3D,Z.__webglTexture,i.TEXTURE0+w)}function tt(P,w){let Z=n.get(P);if(P.version>0&&Z.__version!==P.version){at(Z,P,w);return}e.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture,i.TEXTURE0+w)}let ut={[iu]:i.REPEAT,[js]:i.CLAMP_TO_EDGE,[su]:i.MIRRORED_REPEAT},ct={[wi]:i.NEAREST,[$y]:i.NEAREST_MIPMAP_NEAREST,[Ha]:i.NEAREST_MIPMAP_LINEAR,[zi]:i.LINEAR,[_h]:i.LINEAR_MIPMAP_NEAREST,[Qs]:i.LINEAR_MIPMAP_LINEAR},mt={[Qy]:i.NEVER,[rv]:i.ALWAYS,[tv]:i.LESS,[bg]:i.LEQUAL,[ev]:i.EQUAL,[sv]:i.GEQUAL,[nv]:i.GREATER,[iv]:i.NOTEQUAL};function vt(P,w){if(w.type===ns&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===zi||w.magFilter===_h||w.magFilter===Ha||w.magFilter===Qs||w.minFilter===zi||w.minFilter===_h||w.minFilter===Ha||w.minFilter===Qs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,ut[w.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,ut[w.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,ut[w.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,ct[w.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,ct[w.minFilter]),w.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,mt[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===wi||w.minFilter!==Ha&&w.minFilter!==Qs||w.type===ns&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let Z=t.get("EXT_texture_filter_anisotropic");i.texParameterf(P,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function pt(P,w){let Z=!1;P.__webglInit===void 0&&(P.__webglInit=!0,w.addEventListener("dispose",C));let j=w.source,X=f.get(j);X===void 0&&(X={},f.set(j,X));let et=W(w);if(et!==P.__cacheKey){X[et]===void 0&&(X[et]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),X[et].usedTimes++;let Mt=X[P.__cacheKey];Mt!==void 0&&(X[P.__cacheKey].usedTimes--,Mt.usedTimes===0&&A(w)),P.__cacheKey=et,P.__webglTexture=X[et].texture}return Z}function it(P,w,Z){let j=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(j=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(j=i.TEXTURE_3D);let X=pt(P,w),et=w.source;e.bindTexture(j,P.__webglTexture,i.TEXTURE0+Z);let Mt=n.get(et);if(et.version!==Mt.__version||X===!0){e.activeTexture(i.TEXTURE0+Z);let _t=le.getPrimaries(le.workingColorSpace),Et=w.colorSpace===Ss?null:le.getPrimaries(w.colorSpace),Zt=w.colorSpace===Ss||_t===Et?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Zt);let ft=x(w.image,!1,s.maxTextureSize);ft=fe(w,ft);let xt=r.convert(w.format,w.colorSpace),Nt=r.convert(w.type),Ft=b(w.internalFormat,xt,Nt,w.colorSpace,w.isVideoTexture);vt(j,w);let St,ie=w.mipmaps,Yt=w.isVideoTexture!==!0,de=Mt.__version===void 0||X===!0,z=et.dataReady,yt=U(w,ft);if(w.isDepthTexture)Ft=y(w.format===io,w.type),de&&(Yt?e.texStorage2D(i.TEXTURE_2D,1,Ft,ft.width,ft.height):e.texImage2D(i.TEXTURE_2D,0,Ft,ft.width,ft.height,0,xt,Nt,null));else if(w.isDataTexture)if(ie.length>0){Yt&&de&&e.texStorage2D(i.TEXTURE_2D,yt,Ft,ie[0].width,ie[0].height);for(let nt=0,rt=ie.length;nt<rt;nt++)St=ie[nt],Yt?z&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,St.width,St.height,xt,Nt,St.data):e.texImage2D(i.TEXTURE_2D,nt,Ft,St.width,St.height,0,xt,Nt,St.data);w.generateMipmaps=!1}else Yt?(de&&e.texStorage2D(i.TEXTURE_2D,yt,Ft,ft.width,ft.height),z&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,ft.width,ft.height,xt,Nt,ft.data)):e.texImage2D(i.TEXTURE_2D,0,Ft,ft.width,ft.height,0,xt,Nt,ft.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){Yt&&de&&e.texStorage3D(i.TEXTURE_2D_ARRAY,yt,Ft,ie[0].width,ie[0].height,ft.depth);for(let nt=0,rt=ie.length;nt<rt;nt++)if(St=ie[nt],w.format!==Si)if(xt!==null)if(Yt){if(z)if(w.layerUpdates.size>0){let At=sg(St.width,St.height,w.format,w.type);for(let Tt of w.layerUpdates){let Jt=St.data.subarray(Tt*At/St.data.BYTES_PER_ELEMENT,(Tt+1)*At/St.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,Tt,St.width,St.height,1,xt,Jt)}w.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,St.width,St.height,ft.depth,xt,St.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,Ft,St.width,St.height,ft.depth,0,St.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Yt?z&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,St.width,St.height,ft.depth,xt,Nt,St.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,Ft,St.width,St.height,ft.depth,0,xt,Nt,St.data)}else{Yt&&de&&e.texStorage2D(i.TEXTURE_2D,yt,Ft,ie[0].width,ie[0].height);for(let nt=0,rt=ie.length;nt<rt;nt++)St=ie[nt],w.format!==Si?xt!==null?Yt?z&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,St.width,St.height,xt,St.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,Ft,St.width,St.height,0,St.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Yt?z&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,St.width,St.height,xt,Nt,St.data):e.texImage2D(i.TEXTURE_2D,nt,Ft,St.width,St.height,0,xt,Nt,St.data)}else if(w.isDataArrayTexture)if(Yt){if(de&&e.texStorage3D(i.TEXTURE_2D_ARRAY,yt,Ft,ft.width,ft.height,ft.depth),z)if(w.layerUpdates.size>0){let nt=sg(ft.width,ft.height,w.format,w.type);for(let rt of w.layerUpdates){let At=ft.data.subarray(rt*nt/ft.data.BYTES_PER_ELEMENT,(rt+1)*nt/ft.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,rt,ft.width,ft.height,1,xt,Nt,At)}w.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ft.width,ft.height,ft.depth,xt,Nt,ft.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Ft,ft.width,ft.height,ft.depth,0,xt,Nt,ft.data);else if(w.isData3DTexture)Yt?(de&&e.texStorage3D(i.TEXTURE_3D,yt,Ft,ft.width,ft.height,ft.depth),z&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ft.width,ft.height,ft.depth,xt,Nt,ft.data)):e.texImage3D(i.TEXTURE_3D,0,Ft,ft.width,ft.height,ft.depth,0,xt,Nt,ft.data);else if(w.isFramebufferTexture){if(de)if(Yt)e.texStorage2D(i.TEXTURE_2D,yt,Ft,ft.width,ft.height);else{let nt=ft.width,rt=ft.height;for(let At=0;At<yt;At++)e.texImage2D(i.TEXTURE_2D,At,Ft,nt,rt,0,xt,Nt,null),nt>>=1,rt>>=1}}else if(ie.length>0){if(Yt&&de){let nt=Pt(ie[0]);e.texStorage2D(i.TEXTURE_2D,yt,Ft,nt.width,nt.height)}for(let nt=0,rt=ie.length;nt<rt;nt++)St=ie[nt],Yt?z&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,xt,Nt,St):e.texImage2D(i.TEXTURE_2D,nt,Ft,xt,Nt,St);w.generateMipmaps=!1}else if(Yt){if(de){let nt=Pt(ft);e.texStorage2D(i.TEXTURE_2D,yt,Ft,nt.width,nt.height)}z&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,xt,Nt,ft)}else e.texImage2D(i.TEXTURE_2D,0,Ft,xt,Nt,ft);m(w)&&d(j),Mt.__version=et.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function at(P,w,Z){if(w.image.length!==6)return;let j=pt(P,w),X=w.source;e.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+Z);let et=n.get(X);if(X.version!==et.__version||j===!0){e.activeTexture(i.TEXTURE0+Z);let Mt=le.getPrimaries(le.workingColorSpace),_t=w.colorSpace===Ss?null:le.getPrimaries(w.colorSpace),Et=w.colorSpace===Ss||Mt===_t?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Et);let Zt=w.isCompressedTexture||w.image[0].isCompressedTexture,ft=w.image[0]&&w.image[0].isDataTexture,xt=[];for(let rt=0;rt<6;rt++)!Zt&&!ft?xt[rt]=x(w.image[rt],!0,s.maxCubemapSize):xt[rt]=ft?w.image[rt].image:w.image[rt],xt[rt]=fe(w,xt[rt]);let Nt=xt[0],Ft=r.convert(w.format,w.colorSpace),St=r.convert(w.type),ie=b(w.internalFormat,Ft,St,w.colorSpace),Yt=w.isVideoTexture!==!0,de=et.__version===void 0||j===!0,z=X.dataReady,yt=U(w,Nt);vt(i.TEXTURE_CUBE_MAP,w);let nt;if(Zt){Yt&&de&&e.texStorage2D(i.TEXTURE_CUBE_MAP,yt,ie,Nt.width,Nt.height);for(let rt=0;rt<6;rt++){nt=xt[rt].mipmaps;for(let At=0;At<nt.length;At++){let Tt=nt[At];w.format!==Si?Ft!==null?Yt?z&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At,0,0,Tt.width,Tt.height,Ft,Tt.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At,ie,Tt.width,Tt.height,0,Tt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Yt?z&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At,0,0,Tt.width,Tt.height,Ft,St,Tt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At,ie,Tt.width,Tt.height,0,Ft,St,Tt.data)}}}else{if(nt=w.mipmaps,Yt&&de){nt.length>0&&yt++;let rt=Pt(xt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,yt,ie,rt.width,rt.height)}for(let rt=0;rt<6;rt++)if(ft){Yt?z&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,xt[rt].width,xt[rt].height,Ft,St,xt[rt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ie,xt[rt].width,xt[rt].height,0,Ft,St,xt[rt].data);for(let At=0;At<nt.length;At++){let Jt=nt[At].image[rt].image;Yt?z&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At+1,0,0,Jt.width,Jt.height,Ft,St,Jt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At+1,ie,Jt.width,Jt.height,0,Ft,St,Jt.data)}}else{Yt?z&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,Ft,St,xt[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ie,Ft,St,xt[rt]);for(let At=0;At<nt.length;At++){let Tt=nt[At];Yt?z&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At+1,0,0,Ft,St,Tt.image[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,At+1,ie,Ft,St,Tt.image[rt])}}}m(w)&&d(i.TEXTURE_CUBE_MAP),et.__version=X.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function gt(P,w,Z,j,X,et){let Mt=r.convert(Z.format,Z.colorSpace),_t=r.convert(Z.type),Et=b(Z.internalFormat,Mt,_t,Z.colorSpace),Zt=n.get(w),ft=n.get(Z);if(ft.__renderTarget=w,!Zt.__hasExternalTextures){let xt=Math.max(1,w.width>>et),Nt=Math.max(1,w.height>>et);X===i.TEXTURE_3D||X===i.TEXTURE_2D_ARRAY?e.texImage3D(X,et,Et,xt,Nt,w.depth,0,Mt,_t,null):e.texImage2D(X,et,Et,xt,Nt,0,Mt,_t,null)}e.bindFramebuffer(i.FRAMEBUFFER,P),ee(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,j,X,ft.__webglTexture,0,te(w)):(X===i.TEXTURE_2D||X>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&X<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,j,X,ft.__webglTexture,et),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ot(P,w,Z){if(i.bindRenderbuffer(i.RENDERBUFFER,P),w.depthBuffer){let j=w.depthTexture,X=j&&j.isDepthTexture?j.type:null,et=y(w.stencilBuffer,X),Mt=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=te(w);ee(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,_t,et,w.width,w.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,_t,et,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,et,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Mt,i.RENDERBUFFER,P)}else{let j=w.textures;for(let X=0;X<j.length;X++){let et=j[X],Mt=r.convert(et.format,et.colorSpace),_t=r.convert(et.type),Et=b(et.internalFormat,Mt,_t,et.colorSpace),Zt=te(w);Z&&ee(w)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Zt,Et,w.width,w.height):ee(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Zt,Et,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,Et,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Bt(P,w){if(w&&w.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,P),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let j=n.get(w.depthTexture);j.__renderTarget=w,(!j.__webglTexture||w.depthTexture.image.width!==w.width||w.depthTexture.image.height!==w.height)&&(w.depthTexture.image.width=w.width,w.depthTexture.image.height=w.height,w.depthTexture.needsUpdate=!0),J(w.depthTexture,0);let X=j.__webglTexture,et=te(w);if(w.depthTexture.format===Kr)ee(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,X,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,X,0);else if(w.depthTexture.format===io)ee(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,X,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,X,0);else throw new Error("Unknown depthTexture format")}function Ht(P){let w=n.get(P),Z=P.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==P.depthTexture){let j=P.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),j){let X=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,j.removeEventListener("dispose",X)};j.addEventListener("dispose",X),w.__depthDisposeCallback=X}w.__boundDepthTexture=j}if(P.depthTexture&&!w.__autoAllocateDepthBuffer){if(Z)throw new Error("target.depthTexture not supported in Cube render targets");Bt(w.__webglFramebuffer,P)}else if(Z){w.__webglDepthbuffer=[];for(let j=0;j<6;j++)if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[j]),w.__webglDepthbuffer[j]===void 0)w.__webglDepthbuffer[j]=i.createRenderbuffer(),ot(w.__webglDepthbuffer[j],P,!1);else{let X=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,et=w.__webglDepthbuffer[j];i.bindRenderbuffer(i.RENDERBUFFER,et),i.framebufferRenderbuffer(i.FRAMEBUFFER,X,i.RENDERBUFFER,et)}}else if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),ot(w.__webglDepthbuffer,P,!1);else{let j=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,X=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,X),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,X)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ut(P,w,Z){let j=n.get(P);w!==void 0&&gt(j.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Z!==void 0&&Ht(P)}function ce(P){let w=P.texture,Z=n.get(P),j=n.get(w);P.addEventListener("dispose",D);let X=P.textures,et=P.isWebGLCubeRenderTarget===!0,Mt=X.length>1;if(Mt||(j.__webglTexture===void 0&&(j.__webglTexture=i.createTexture()),j.__version=w.version,o.memory.textures++),et){Z.__webglFramebuffer=[];for(let _t=0;_t<6;_t++)if(w.mipmaps&&w.mipmaps.length>0){Z.__webglFramebuffer[_t]=[];for(let Et=0;Et<w.mipmaps.length;Et++)Z.__webglFramebuffer[_t][Et]=i.createFramebuffer()}else Z.__webglFramebuffer[_t]=i.createFramebuffer()}else{if(w.mipmaps&&w.mipmaps.length>0){Z.__webglFramebuffer=[];for(let _t=0;_t<w.mipmaps.length;_t++)Z.__webglFramebuffer[_t]=i.createFramebuffer()}else Z.__webglFramebuffer=i.createFramebuffer();if(Mt)for(let _t=0,Et=X.length;_t<Et;_t++){let Zt=n.get(X[_t]);Zt.__webglTexture===void 0&&(Zt.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&ee(P)===!1){Z.__webglMultisampledFramebuffer=i.createFramebuffer(),Z.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let _t=0;_t<X.length;_t++){let Et=X[_t];Z.__webglColorRenderbuffer[_t]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Z.__webglColorRenderbuffer[_t]);let Zt=r.convert(Et.format,Et.colorSpace),ft=r.convert(Et.type),xt=b(Et.internalFormat,Zt,ft,Et.colorSpace,P.isXRRenderTarget===!0),Nt=te(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,Nt,xt,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.RENDERBUFFER,Z.__webglColorRenderbuffer[_t])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&(Z.__webglDepthRenderbuffer=i.createRenderbuffer(),ot(Z.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(et){e.bindTexture(i.TEXTURE_CUBE_MAP,j.__webglTexture),vt(i.TEXTURE_CUBE_MAP,w);for(let _t=0;_t<6;_t++)if(w.mipmaps&&w.mipmaps.length>0)for(let Et=0;Et<w.mipmaps.length;Et++)gt(Z.__webglFramebuffer[_t][Et],P,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,Et);else gt(Z.__webglFramebuffer[_t],P,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0);m(w)&&d(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(Mt){for(let _t=0,Et=X.length;_t<Et;_t++){let Zt=X[_t],ft=n.get(Zt);e.bindTexture(i.TEXTURE_2D,ft.__webglTexture),vt(i.TEXTURE_2D,Zt),gt(Z.__webglFramebuffer,P,Zt,i.COLOR_ATTACHMENT0+_t,i.TEXTURE_2D,0),m(Zt)&&d(i.TEXTURE_2D)}e.unbindTexture()}else{let _t=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(_t=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(_t,j.__webglTexture),vt(_t,w),w.mipmaps&&w.mipmaps.length>0)for(let Et=0;Et<w.mipmaps.length;Et++)gt(Z.__webglFramebuffer[Et],P,w,i.COLOR_ATTACHMENT0,_t,Et);else gt(Z.__webglFramebuffer,P,w,i.COLOR_ATTACHMENT0,_t,0);m(w)&&d(_t),e.unbindTexture()}P.depthBuffer&&Ht(P)}function Kt(P){let w=P.textures;for(let Z=0,j=w.length;Z<j;Z++){let X=w[Z];if(m(X)){let et=M(P),Mt=n.get(X).__webglTexture;e.bindTexture(et,Mt),d(et),e.unbindTexture()}}}let he=[],V=[];function Je(P){if(P.samples>0){if(ee(P)===!1){let w=P.textures,Z=P.width,j=P.height,X=i.COLOR_BUFFER_BIT,et=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Mt=n.get(P),_t=w.length>1;if(_t)for(let Et=0;Et<w.length;Et++)e.bindFramebuffer(i.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Et,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,Mt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Et,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer);for(let Et=0;Et<w.length;Et++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(X|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(X|=i.STENCIL_BUFFER_BIT)),_t){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Mt.__webglColorRenderbuffer[Et]);let Zt=n.get(w[Et]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,Zt,0)}i.blitFramebuffer(0,0,Z,j,0,0,Z,j,X,i.NEAREST),l===!0&&(he.length=0,V.length=0,he.push(i.COLOR_ATTACHMENT0+Et),P.depthBuffer&&P.resolveDepthBuffer===!1&&(he.push(et),V.push(et),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,V)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,he))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),_t)for(let Et=0;Et<w.length;Et++){e.bindFramebuffer(i.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Et,i.RENDERBUFFER,Mt.__webglColorRenderbuffer[Et]);let Zt=n.get(w[Et]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,Mt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Et,i.TEXTURE_2D,Zt,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){let w=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function te(P){return Math.min(s.maxSamples,P.samples)}function ee(P){let w=n.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Gt(P){let w=o.render.frame;h.get(P)!==w&&(h.set(P,w),P.update())}function fe(P,w){let Z=P.colorSpace,j=P.format,X=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||Z!==co&&Z!==Ss&&(le.getTransfer(Z)===Ee?(j!==Si||X!==rs)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",Z)),w}function Pt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=F,this.resetTextureUnits=G,this.setTexture2D=J,this.setTexture2DArray=K,this.setTexture3D=Q,this.setTextureCube=tt,this.rebindTextures=Ut,this.setupRenderTarget=ce,this.updateRenderTargetMipmap=Kt,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=Ht,this.setupFrameBufferTexture=gt,this.useMultisampledRTT=ee}function f1(i,t){function e(n,s=Ss){let r,o=le.getTransfer(s);if(n===rs)return i.UNSIGNED_BYTE;if(n===hf)return i.UNSIGNED_SHORT_4_4_4_4;if(n===uf)return i.UNSIGNED_SHORT_5_5_5_1;if(n===pg)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===fg)return i.BYTE;if(n===dg)return i.SHORT;if(n===Yo)return i.UNSIGNED_SHORT;if(n===cf)return i.INT;if(n===tr)return i.UNSIGNED_INT;if(n===ns)return i.FLOAT;if(n===jo)return i.HALF_FLOAT;if(n===mg)return i.ALPHA;if(n===gg)return i.RGB;if(n===Si)return i.RGBA;if(n===_g)return i.LUMINANCE;if(n===xg)return i.LUMINANCE_ALPHA;if(n===Kr)return i.DEPTH_COMPONENT;if(n===io)return i.DEPTH_STENCIL;if(n===yg)return i.RED;if(n===ff)return i.RED_INTEGER;if(n===vg)return i.RG;if(n===df)return i.RG_INTEGER;if(n===pf)return i.RGBA_INTEGER;if(n===fl||n===dl||n===pl||n===ml)if(o===Ee)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===fl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ml)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===fl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===dl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===pl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ml)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===ru||n===ou||n===au||n===lu)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===ru)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ou)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===au)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===lu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===cu||n===hu||n===uu)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===cu||n===hu)return o===Ee?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===uu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===fu||n===du||n===pu||n===mu||n===gu||n===_u||n===xu||n===yu||n===vu||n===Mu||n===bu||n===Su||n===wu||n===Eu)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===fu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===du)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===pu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===mu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===gu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===_u)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===xu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===yu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===vu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Mu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===bu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Su)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===wu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Eu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===gl||n===Au||n===Tu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===gl)return o===Ee?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Au)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Tu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Mg||n===Cu||n===Ru||n===Pu)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===gl)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Cu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ru)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Pu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===no?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var qu=class extends Un{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}},Jn=class extends wn{constructor(){super(),this.isGroup=!0,this.type="Group"}},d1={type:"move"},qo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Jn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Jn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new L,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new L),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Jn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new L,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new L),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,n),d=this._getHandJoint(c,x);m!==null&&(d.matrix.fromArray(m.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=m.radius),d.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),p=.02,g=.005;c.inputState.pinching&&f>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(d1)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Jn;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},p1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,m1=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Yu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,n){if(this.texture===null){let s=new Sn,r=t.properties.get(s);r.__webglTexture=e.texture,(e.depthNear!=n.depthNear||e.depthFar!=n.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new Ti({vertexShader:p1,fragmentShader:m1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Le(new ao(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},$u=class extends os{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,p=null,g=null,x=new Yu,m=e.getContextAttributes(),d=null,M=null,b=[],y=[],U=new Qt,C=null,D=new Un;D.viewport=new Ve;let O=new Un;O.viewport=new Ve;let A=[D,O],S=new qu,R=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(it){let at=b[it];return at===void 0&&(at=new qo,b[it]=at),at.getTargetRaySpace()},this.getControllerGrip=function(it){let at=b[it];return at===void 0&&(at=new qo,b[it]=at),at.getGripSpace()},this.getHand=function(it){let at=b[it];return at===void 0&&(at=new qo,b[it]=at),at.getHandSpace()};function F(it){let at=y.indexOf(it.inputSource);if(at===-1)return;let gt=b[at];gt!==void 0&&(gt.update(it.inputSource,it.frame,c||o),gt.dispatchEvent({type:it.type,data:it.inputSource}))}function W(){s.removeEventListener("select",F),s.removeEventListener("selectstart",F),s.removeEventListener("selectend",F),s.removeEventListener("squeeze",F),s.removeEventListener("squeezestart",F),s.removeEventListener("squeezeend",F),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",J);for(let it=0;it<b.length;it++){let at=y[it];at!==null&&(y[it]=null,b[it].disconnect(at))}R=null,G=null,x.reset(),t.setRenderTarget(d),p=null,f=null,u=null,s=null,M=null,pt.stop(),n.isPresenting=!1,t.setPixelRatio(C),t.setSize(U.width,U.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(it){r=it,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(it){a=it,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(it){c=it},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(it){if(s=it,s!==null){if(d=t.getRenderTarget(),s.addEventListener("select",F),s.addEventListener("selectstart",F),s.addEventListener("selectend",F),s.addEventListener("squeeze",F),s.addEventListener("squeezestart",F),s.addEventListener("squeezeend",F),s.addEventListener("end",W),s.addEventListener("inputsourceschange",J),m.xrCompatible!==!0&&await e.makeXRCompatible(),C=t.getPixelRatio(),t.getSize(U),s.renderState.layers===void 0){let at={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,at),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),M=new as(p.framebufferWidth,p.framebufferHeight,{format:Si,type:rs,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let at=null,gt=null,ot=null;m.depth&&(ot=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,at=m.stencil?io:Kr,gt=m.stencil?no:tr);let Bt={colorFormat:e.RGBA8,depthFormat:ot,scaleFactor:r};u=new XRWebGLBinding(s,e),f=u.createProjectionLayer(Bt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),M=new as(f.textureWidth,f.textureHeight,{format:Si,type:rs,depthTexture:new Pl(f.textureWidth,f.textureHeight,gt,void 0,void 0,void 0,void 0,void 0,void 0,at),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),pt.setContext(s),pt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return x.getDepthTexture()};function J(it){for(let at=0;at<it.removed.length;at++){let gt=it.removed[at],ot=y.indexOf(gt);ot>=0&&(y[ot]=null,b[ot].disconnect(gt))}for(let at=0;at<it.added.length;at++){let gt=it.added[at],ot=y.indexOf(gt);if(ot===-1){for(let Ht=0;Ht<b.length;Ht++)if(Ht>=y.length){y.push(gt),ot=Ht;break}else if(y[Ht]===null){y[Ht]=gt,ot=Ht;break}if(ot===-1)break}let Bt=b[ot];Bt&&Bt.connect(gt)}}let K=new L,Q=new L;function tt(it,at,gt){K.setFromMatrixPosition(at.matrixWorld),Q.setFromMatrixPosition(gt.matrixWorld);let ot=K.distanceTo(Q),Bt=at.projectionMatrix.elements,Ht=gt.projectionMatrix.elements,Ut=Bt[14]/(Bt[10]-1),ce=Bt[14]/(Bt[10]+1),Kt=(Bt[9]+1)/Bt[5],he=(Bt[9]-1)/Bt[5],V=(Bt[8]-1)/Bt[0],Je=(Ht[8]+1)/Ht[0],te=Ut*V,ee=Ut*Je,Gt=ot/(-V+Je),fe=Gt*-V;if(at.matrixWorld.decompose(it.position,it.quaternion,it.scale),it.translateX(fe),it.translateZ(Gt),it.matrixWorld.compose(it.position,it.quaternion,it.scale),it.matrixWorldInverse.copy(it.matrixWorld).invert(),Bt[10]===-1)it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse);else{let Pt=Ut+Gt,P=ce+Gt,w=te-fe,Z=ee+(ot-fe),j=Kt*ce/P*Pt,X=he*ce/P*Pt;it.projectionMatrix.makePerspective(w,Z,j,X,Pt,P),it.projectionMatrixInverse.copy(it.projectionMatrix).invert()}}function ut(it,at){at===null?it.matrixWorld.copy(it.matrix):it.matrixWorld.multiplyMatrices(at.matrixWorld,it.matrix),it.matrixWorldInverse.copy(it.matrixWorld).invert()}this.updateCamera=function(it){if(s===null)return;let at=it.near,gt=it.far;x.texture!==null&&(x.depthNear>0&&(at=x.depthNear),x.depthFar>0&&(gt=x.depthFar)),S.near=O.near=D.near=at,S.far=O.far=D.far=gt,(R!==S.near||G!==S.far)&&(s.updateRenderState({depthNear:S.near,depthFar:S.far}),R=S.near,G=S.far),D.layers.mask=it.layers.mask|2,O.layers.mask=it.layers.mask|4,S.layers.mask=D.layers.mask|O.layers.mask;let ot=it.parent,Bt=S.cameras;ut(S,ot);for(let Ht=0;Ht<Bt.length;Ht++)ut(Bt[Ht],ot);Bt.length===2?tt(S,D,O):S.projectionMatrix.copy(D.projectionMatrix),ct(it,S,ot)};function ct(it,at,gt){gt===null?it.matrix.copy(at.matrixWorld):(it.matrix.copy(gt.matrixWorld),it.matrix.invert(),it.matrix.multiply(at.matrixWorld)),it.matrix.decompose(it.position,it.quaternion,it.scale),it.updateMatrixWorld(!0),it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse),it.isPerspectiveCamera&&(it.fov=Zo*2*Math.atan(1/it.projectionMatrix.elements[5]),it.zoom=1)}this.getCamera=function(){return S},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(it){l=it,f!==null&&(f.fixedFoveation=it),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=it)},this.hasDepthSensing=function(){return x.texture!==null},this.getDepthSensingMesh=function(){return x.getMesh(S)};let mt=null;function vt(it,at){if(h=at.getViewerPose(c||o),g=at,h!==null){let gt=h.views;p!==null&&(t.setRenderTargetFramebuffer(M,p.framebuffer),t.setRenderTarget(M));let ot=!1;gt.length!==S.cameras.length&&(S.cameras.length=0,ot=!0);for(let Ht=0;Ht<gt.length;Ht++){let Ut=gt[Ht],ce=null;if(p!==null)ce=p.getViewport(Ut);else{let he=u.getViewSubImage(f,Ut);ce=he.viewport,Ht===0&&(t.setRenderTargetTextures(M,he.colorTexture,f.ignoreDepthValues?void 0:he.depthStencilTexture),t.setRenderTarget(M))}let Kt=A[Ht];Kt===void 0&&(Kt=new Un,Kt.layers.enable(Ht),Kt.viewport=new Ve,A[Ht]=Kt),Kt.matrix.fromArray(Ut.transform.matrix),Kt.matrix.decompose(Kt.position,Kt.quaternion,Kt.scale),Kt.projectionMatrix.fromArray(Ut.projectionMatrix),Kt.projectionMatrixInverse.copy(Kt.projectionMatrix).invert(),Kt.viewport.set(ce.x,ce.y,ce.width,ce.height),Ht===0&&(S.matrix.copy(Kt.matrix),S.matrix.decompose(S.position,S.quaternion,S.scale)),ot===!0&&S.cameras.push(Kt)}let Bt=s.enabledFeatures;if(Bt&&Bt.includes("depth-sensing")){let Ht=u.getDepthInformation(gt[0]);Ht&&Ht.isValid&&Ht.texture&&x.init(t,Ht,s.renderState)}}for(let gt=0;gt<b.length;gt++){let ot=y[gt],Bt=b[gt];ot!==null&&Bt!==void 0&&Bt.update(ot,at,c||o)}mt&&mt(it,at),at.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:at}),g=null}let pt=new Tg;pt.setAnimationLoop(vt),this.setAnimationLoop=function(it){mt=it},this.dispose=function(){}}},$s=new Ai,g1=new He;function _1(i,t){function e(m,d){m.matrixAutoUpdate===!0&&m.updateMatrix(),d.value.copy(m.matrix)}function n(m,d){d.color.getRGB(m.fogColor.value,Ag(i)),d.isFog?(m.fogNear.value=d.near,m.fogFar.value=d.far):d.isFogExp2&&(m.fogDensity.value=d.density)}function s(m,d,M,b,y){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(m,d):d.isMeshToonMaterial?(r(m,d),u(m,d)):d.isMeshPhongMaterial?(r(m,d),h(m,d)):d.isMeshStandardMaterial?(r(m,d),f(m,d),d.isMeshPhysicalMaterial&&p(m,d,y)):d.isMeshMatcapMaterial?(r(m,d),g(m,d)):d.isMeshDepthMaterial?r(m,d):d.isMeshDistanceMaterial?(r(m,d),x(m,d)):d.isMeshNormalMaterial?r(m,d):d.isLineBasicMaterial?(o(m,d),d.isLineDashedMaterial&&a(m,d)):d.isPointsMaterial?l(m,d,M,b):d.isSpriteMaterial?c(m,d):d.isShadowMaterial?(m.color.value.copy(d.color),m.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(m,d){m.opacity.value=d.opacity,d.color&&m.diffuse.value.copy(d.color),d.emissive&&m.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(m.map.value=d.map,e(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.bumpMap&&(m.bumpMap.value=d.bumpMap,e(d.bumpMap,m.bumpMapTransform),m.bumpScale.value=d.bumpScale,d.side===kn&&(m.bumpScale.value*=-1)),d.normalMap&&(m.normalMap.value=d.normalMap,e(d.normalMap,m.normalMapTransform),m.normalScale.value.copy(d.normalScale),d.side===kn&&m.normalScale.value.negate()),d.displacementMap&&(m.displacementMap.value=d.displacementMap,e(d.displacementMap,m.displacementMapTransform),m.displacementScale.value=d.displacementScale,m.displacementBias.value=d.displacementBias),d.emissiveMap&&(m.emissiveMap.value=d.emissiveMap,e(d.emissiveMap,m.emissiveMapTransform)),d.specularMap&&(m.specularMap.value=d.specularMap,e(d.specularMap,m.specularMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest);let M=t.get(d),b=M.envMap,y=M.envMapRotation;b&&(m.envMap.value=b,$s.copy(y),$s.x*=-1,$s.y*=-1,$s.z*=-1,b.isCubeTexture&&b.isRenderTargetTexture===!1&&($s.y*=-1,$s.z*=-1),m.envMapRotation.value.setFromMatrix4(g1.makeRotationFromEuler($s)),m.flipEnvMap.value=b.isCubeTexture&&b.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=d.reflectivity,m.ior.value=d.ior,m.refractionRatio.value=d.refractionRatio),d.lightMap&&(m.lightMap.value=d.lightMap,m.lightMapIntensity.value=d.lightMapIntensity,e(d.lightMap,m.lightMapTransform)),d.aoMap&&(m.aoMap.value=d.aoMap,m.aoMapIntensity.value=d.aoMapIntensity,e(d.aoMap,m.aoMapTransform))}function o(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,d.map&&(m.map.value=d.map,e(d.map,m.mapTransform))}function a(m,d){m.dashSize.value=d.dashSize,m.totalSize.value=d.dashSize+d.gapSize,m.scale.value=d.scale}function l(m,d,M,b){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.size.value=d.size*M,m.scale.value=b*.5,d.map&&(m.map.value=d.map,e(d.map,m.uvTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function c(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.rotation.value=d.rotation,d.map&&(m.map.value=d.map,e(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function h(m,d){m.specular.value.copy(d.specular),m.shininess.value=Math.max(d.shininess,1e-4)}function u(m,d){d.gradientMap&&(m.gradientMap.value=d.gradientMap)}function f(m,d){m.metalness.value=d.metalness,d.metalnessMap&&(m.metalnessMap.value=d.metalnessMap,e(d.metalnessMap,m.metalnessMapTransform)),m.roughness.value=d.roughness,d.roughnessMap&&(m.roughnessMap.value=d.roughnessMap,e(d.roughnessMap,m.roughnessMapTransform)),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)}function p(m,d,M){m.ior.value=d.ior,d.sheen>0&&(m.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),m.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(m.sheenColorMap.value=d.sheenColorMap,e(d.sheenColorMap,m.sheenColorMapTransform)),d.sheenRoughnessMap&&(m.sheenRoughnessMap.value=d.sheenRoughnessMap,e(d.sheenRoughnessMap,m.sheenRoughnessMapTransform))),d.clearcoat>0&&(m.clearcoat.value=d.clearcoat,m.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(m.clearcoatMap.value=d.clearcoatMap,e(d.clearcoatMap,m.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,e(d.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(m.clearcoatNormalMap.value=d.clearcoatNormalMap,e(d.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===kn&&m.clearcoatNormalScale.value.negate())),d.dispersion>0&&(m.dispersion.value=d.dispersion),d.iridescence>0&&(m.iridescence.value=d.iridescence,m.iridescenceIOR.value=d.iridescenceIOR,m.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(m.iridescenceMap.value=d.iridescenceMap,e(d.iridescenceMap,m.iridescenceMapTransform)),d.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=d.iridescenceThicknessMap,e(d.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),d.transmission>0&&(m.transmission.value=d.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),d.transmissionMap&&(m.transmissionMap.value=d.transmissionMap,e(d.transmissionMap,m.transmissionMapTransform)),m.thickness.value=d.thickness,d.thicknessMap&&(m.thicknessMap.value=d.thicknessMap,e(d.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=d.attenuationDistance,m.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(m.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(m.anisotropyMap.value=d.anisotropyMap,e(d.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=d.specularIntensity,m.specularColor.value.copy(d.specularColor),d.specularColorMap&&(m.specularColorMap.value=d.specularColorMap,e(d.specularColorMap,m.specularColorMapTransform)),d.specularIntensityMap&&(m.specularIntensityMap.value=d.specularIntensityMap,e(d.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,d){d.matcap&&(m.matcap.value=d.matcap)}function x(m,d){let M=t.get(d).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function x1(i,t,e,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(M,b){let y=b.program;n.uniformBlockBinding(M,y)}function c(M,b){let y=s[M.id];y===void 0&&(g(M),y=h(M),s[M.id]=y,M.addEventListener("dispose",m));let U=b.program;n.updateUBOMapping(M,U);let C=t.render.frame;r[M.id]!==C&&(f(M),r[M.id]=C)}function h(M){let b=u();M.__bindingPointIndex=b;let y=i.createBuffer(),U=M.__size,C=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,y),i.bufferData(i.UNIFORM_BUFFER,U,C),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,b,y),y}function u(){for(let M=0;M<a;M++)if(o.indexOf(M)===-1)return o.push(M),M;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(M){let b=s[M.id],y=M.uniforms,U=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,b);for(let C=0,D=y.length;C<D;C++){let O=Array.isArray(y[C])?y[C]:[y[C]];for(let A=0,S=O.length;A<S;A++){let R=O[A];if(p(R,C,A,U)===!0){let G=R.__offset,F=Array.isArray(R.value)?R.value:[R.value],W=0;for(let J=0;J<F.length;J++){let K=F[J],Q=x(K);typeof K=="number"||typeof K=="boolean"?(R.__data[0]=K,i.bufferSubData(i.UNIFORM_BUFFER,G+W,R.__data)):K.isMatrix3?(R.__data[0]=K.elements[0],R.__data[1]=K.elements[1],R.__data[2]=K.elements[2],R.__data[3]=0,R.__data[4]=K.elements[3],R.__data[5]=K.elements[4],R.__data[6]=K.elements[5],R.__data[7]=0,R.__data[8]=K.elements[6],R.__data[9]=K.elements[7],R.__data[10]=K.elements[8],R.__data[11]=0):(K.toArray(R.__data,W),W+=Q.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,G,R.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function p(M,b,y,U){let C=M.value,D=b+"_"+y;if(U[D]===void 0)return typeof C=="number"||typeof C=="boolean"?U[D]=C:U[D]=C.clone(),!0;{let O=U[D];if(typeof C=="number"||typeof C=="boolean"){if(O!==C)return U[D]=C,!0}else if(O.equals(C)===!1)return O.copy(C),!0}return!1}function g(M){let b=M.uniforms,y=0,U=16;for(let D=0,O=b.length;D<O;D++){let A=Array.isArray(b[D])?b[D]:[b[D]];for(let S=0,R=A.length;S<R;S++){let G=A[S],F=Array.isArray(G.value)?G.value:[G.value];for(let W=0,J=F.length;W<J;W++){let K=F[W],Q=x(K),tt=y%U,ut=tt%Q.boundary,ct=tt+ut;y+=ut,ct!==0&&U-ct<Q.storage&&(y+=U-ct),G.__data=new Float32Array(Q.storage/Float32Array.BYTES_PER_ELEMENT),G.__offset=y,y+=Q.storage}}}let C=y%U;return C>0&&(y+=U-C),M.__size=y,M.__cache={},this}function x(M){let b={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(b.boundary=4,b.storage=4):M.isVector2?(b.boundary=8,b.storage=8):M.isVector3||M.isColor?(b.boundary=16,b.storage=12):M.isVector4?(b.boundary=16,b.storage=16):M.isMatrix3?(b.boundary=48,b.storage=48):M.isMatrix4?(b.boundary=64,b.storage=64):M.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",M),b}function m(M){let b=M.target;b.removeEventListener("dispose",m);let y=o.indexOf(b.__bindingPointIndex);o.splice(y,1),i.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function d(){for(let M in s)i.deleteBuffer(s[M]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}var Il=class{constructor(t={}){let{canvas:e=bv(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reverseDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let g=new Uint32Array(4),x=new Int32Array(4),m=null,d=null,M=[],b=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=hi,this.toneMapping=Es,this.toneMappingExposure=1;let y=this,U=!1,C=0,D=0,O=null,A=-1,S=null,R=new Ve,G=new Ve,F=null,W=new se(0),J=0,K=e.width,Q=e.height,tt=1,ut=null,ct=null,mt=new Ve(0,0,K,Q),vt=new Ve(0,0,K,Q),pt=!1,it=new Cl,at=!1,gt=!1,ot=new He,Bt=new He,Ht=new L,Ut=new Ve,ce={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Kt=!1;function he(){return O===null?tt:1}let V=n;function Je(E,B){return e.getContext(E,B)}try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${lf}`),e.addEventListener("webglcontextlost",rt,!1),e.addEventListener("webglcontextrestored",At,!1),e.addEventListener("webglcontextcreationerror",Tt,!1),V===null){let B="webgl2";if(V=Je(B,E),V===null)throw Je(B)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(E){throw console.error("THREE.WebGLRenderer: "+E.message),E}let te,ee,Gt,fe,Pt,P,w,Z,j,X,et,Mt,_t,Et,Zt,ft,xt,Nt,Ft,St,ie,Yt,de,z;function yt(){te=new US(V),te.init(),Yt=new f1(V,te),ee=new CS(V,te,t,Yt),Gt=new c1(V,te),ee.reverseDepthBuffer&&f&&Gt.buffers.depth.setReversed(!0),fe=new FS(V),Pt=new Kw,P=new u1(V,te,Gt,Pt,ee,Yt,fe),w=new PS(y),Z=new DS(y),j=new Wv(V),de=new AS(V,j),X=new NS(V,j,fe,de),et=new BS(V,X,j,fe),Ft=new kS(V,ee,P),ft=new RS(Pt),Mt=new Zw(y,w,Z,te,ee,de,ft),_t=new _1(y,Pt),Et=new jw,Zt=new s1(te),Nt=new ES(y,w,Z,Gt,et,p,l),xt=new a1(y,et,ee),z=new x1(V,fe,ee,Gt),St=new TS(V,te,fe),ie=new OS(V,te,fe),fe.programs=Mt.programs,y.capabilities=ee,y.extensions=te,y.properties=Pt,y.renderLists=Et,y.shadowMap=xt,y.state=Gt,y.info=fe}yt();let nt=new $u(y,V);this.xr=nt,this.getContext=function(){return V},this.getContextAttributes=function(){return V.getContextAttributes()},this.forceContextLoss=function(){let E=te.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=te.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return tt},this.setPixelRatio=function(E){E!==void 0&&(tt=E,this.setSize(K,Q,!1))},this.getSize=function(E){return E.set(K,Q)},this.setSize=function(E,B,q=!0){if(nt.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}K=E,Q=B,e.width=Math.floor(E*tt),e.height=Math.floor(B*tt),q===!0&&(e.style.width=E+"px",e.style.height=B+"px"),this.setViewport(0,0,E,B)},this.getDrawingBufferSize=function(E){return E.set(K*tt,Q*tt).floor()},this.setDrawingBufferSize=function(E,B,q){K=E,Q=B,tt=q,e.width=Math.floor(E*q),e.height=Math.floor(B*q),this.setViewport(0,0,E,B)},this.getCurrentViewport=function(E){return E.copy(R)},this.getViewport=function(E){return E.copy(mt)},this.setViewport=function(E,B,q,Y){E.isVector4?mt.set(E.x,E.y,E.z,E.w):mt.set(E,B,q,Y),Gt.viewport(R.copy(mt).multiplyScalar(tt).round())},this.getScissor=function(E){return E.copy(vt)},this.setScissor=function(E,B,q,Y){E.isVector4?vt.set(E.x,E.y,E.z,E.w):vt.set(E,B,q,Y),Gt.scissor(G.copy(vt).multiplyScalar(tt).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(E){Gt.setScissorTest(pt=E)},this.setOpaqueSort=function(E){ut=E},this.setTransparentSort=function(E){ct=E},this.getClearColor=function(E){return E.copy(Nt.getClearColor())},this.setClearColor=function(){Nt.setClearColor.apply(Nt,arguments)},this.getClearAlpha=function(){return Nt.getClearAlpha()},this.setClearAlpha=function(){Nt.setClearAlpha.apply(Nt,arguments)},this.clear=function(E=!0,B=!0,q=!0){let Y=0;if(E){let H=!1;if(O!==null){let ht=O.texture.format;H=ht===pf||ht===df||ht===ff}if(H){let ht=O.texture.type,bt=ht===rs||ht===tr||ht===Yo||ht===no||ht===hf||ht===uf,Ot=Nt.getClearColor(),Lt=Nt.getClearAlpha(),Wt=Ot.r,qt=Ot.g,Dt=Ot.b;bt?(g[0]=Wt,g[1]=qt,g[2]=Dt,g[3]=Lt,V.clearBufferuiv(V.COLOR,0,g)):(x[0]=Wt,x[1]=qt,x[2]=Dt,x[3]=Lt,V.clearBufferiv(V.COLOR,0,x))}else Y|=V.COLOR_BUFFER_BIT}B&&(Y|=V.DEPTH_BUFFER_BIT),q&&(Y|=V.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),V.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",rt,!1),e.removeEventListener("webglcontextrestored",At,!1),e.removeEventListener("webglcontextcreationerror",Tt,!1),Et.dispose(),Zt.dispose(),Pt.dispose(),w.dispose(),Z.dispose(),et.dispose(),de.dispose(),z.dispose(),Mt.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Vn),nt.removeEventListener("sessionend",Wi),Nn.stop()};function rt(E){E.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),U=!0}function At(){console.log("THREE.WebGLRenderer: Context Restored."),U=!1;let E=fe.autoReset,B=xt.enabled,q=xt.autoUpdate,Y=xt.needsUpdate,H=xt.type;yt(),fe.autoReset=E,xt.enabled=B,xt.autoUpdate=q,xt.needsUpdate=Y,xt.type=H}function Tt(E){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function Jt(E){let B=E.target;B.removeEventListener("dispose",Jt),Fe(B)}function Fe(E){an(E),Pt.remove(E)}function an(E){let B=Pt.get(E).programs;B!==void 0&&(B.forEach(function(q){Mt.releaseProgram(q)}),E.isShaderMaterial&&Mt.releaseShaderCache(E))}this.renderBufferDirect=function(E,B,q,Y,H,ht){B===null&&(B=ce);let bt=H.isMesh&&H.matrixWorld.determinant()<0,Ot=hc(E,B,q,Y,H);Gt.setMaterial(Y,bt);let Lt=q.index,Wt=1;if(Y.wireframe===!0){if(Lt=X.getWireframeAttribute(q),Lt===void 0)return;Wt=2}let qt=q.drawRange,Dt=q.attributes.position,oe=qt.start*Wt,ve=(qt.start+qt.count)*Wt;ht!==null&&(oe=Math.max(oe,ht.start*Wt),ve=Math.min(ve,(ht.start+ht.count)*Wt)),Lt!==null?(oe=Math.max(oe,0),ve=Math.min(ve,Lt.count)):Dt!=null&&(oe=Math.max(oe,0),ve=Math.min(ve,Dt.count));let Se=ve-oe;if(Se<0||Se===1/0)return;de.setup(H,Y,Ot,q,Lt);let ln,ue=St;if(Lt!==null&&(ln=j.get(Lt),ue=ie,ue.setIndex(ln)),H.isMesh)Y.wireframe===!0?(Gt.setLineWidth(Y.wireframeLinewidth*he()),ue.setMode(V.LINES)):ue.setMode(V.TRIANGLES);else if(H.isLine){let kt=Y.linewidth;kt===void 0&&(kt=1),Gt.setLineWidth(kt*he()),H.isLineSegments?ue.setMode(V.LINES):H.isLineLoop?ue.setMode(V.LINE_LOOP):ue.setMode(V.LINE_STRIP)}else H.isPoints?ue.setMode(V.POINTS):H.isSprite&&ue.setMode(V.TRIANGLES);if(H.isBatchedMesh)if(H._multiDrawInstances!==null)ue.renderMultiDrawInstances(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount,H._multiDrawInstances);else if(te.get("WEBGL_multi_draw"))ue.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{let kt=H._multiDrawStarts,ke=H._multiDrawCounts,pe=H._multiDrawCount,On=Lt?j.get(Lt).bytesPerElement:1,Ii=Pt.get(Y).currentProgram.getUniforms();for(let yn=0;yn<pe;yn++)Ii.setValue(V,"_gl_DrawID",yn),ue.render(kt[yn]/On,ke[yn])}else if(H.isInstancedMesh)ue.renderInstances(oe,Se,H.count);else if(q.isInstancedBufferGeometry){let kt=q._maxInstanceCount!==void 0?q._maxInstanceCount:1/0,ke=Math.min(q.instanceCount,kt);ue.renderInstances(oe,Se,ke)}else ue.render(oe,Se)};function _e(E,B,q){E.transparent===!0&&E.side===bi&&E.forceSinglePass===!1?(E.side=kn,E.needsUpdate=!0,lr(E,B,q),E.side=As,E.needsUpdate=!0,lr(E,B,q),E.side=bi):lr(E,B,q)}this.compile=function(E,B,q=null){q===null&&(q=E),d=Zt.get(q),d.init(B),b.push(d),q.traverseVisible(function(H){H.isLight&&H.layers.test(B.layers)&&(d.pushLight(H),H.castShadow&&d.pushShadow(H))}),E!==q&&E.traverseVisible(function(H){H.isLight&&H.layers.test(B.layers)&&(d.pushLight(H),H.castShadow&&d.pushShadow(H))}),d.setupLights();let Y=new Set;return E.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;let ht=H.material;if(ht)if(Array.isArray(ht))for(let bt=0;bt<ht.length;bt++){let Ot=ht[bt];_e(Ot,q,H),Y.add(Ot)}else _e(ht,q,H),Y.add(ht)}),b.pop(),d=null,Y},this.compileAsync=function(E,B,q=null){let Y=this.compile(E,B,q);return new Promise(H=>{function ht(){if(Y.forEach(function(bt){Pt.get(bt).currentProgram.isReady()&&Y.delete(bt)}),Y.size===0){H(E);return}setTimeout(ht,10)}te.get("KHR_parallel_shader_compile")!==null?ht():setTimeout(ht,10)})};let je=null;function Ie(E){je&&je(E)}function Vn(){Nn.stop()}function Wi(){Nn.start()}let Nn=new Tg;Nn.setAnimationLoop(Ie),typeof self<"u"&&Nn.setContext(self),this.setAnimationLoop=function(E){je=E,nt.setAnimationLoop(E),E===null?Nn.stop():Nn.start()},nt.addEventListener("sessionstart",Vn),nt.addEventListener("sessionend",Wi),this.render=function(E,B){if(B!==void 0&&B.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(U===!0)return;if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(B),B=nt.getCamera()),E.isScene===!0&&E.onBeforeRender(y,E,B,O),d=Zt.get(E,b.length),d.init(B),b.push(d),Bt.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),it.setFromProjectionMatrix(Bt),gt=this.localClippingEnabled,at=ft.init(this.clippingPlanes,gt),m=Et.get(E,M.length),m.init(),M.push(m),nt.enabled===!0&&nt.isPresenting===!0){let ht=y.xr.getDepthSensingMesh();ht!==null&&xn(ht,B,-1/0,y.sortObjects)}xn(E,B,0,y.sortObjects),m.finish(),y.sortObjects===!0&&m.sort(ut,ct),Kt=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Kt&&Nt.addToRenderList(m,E),this.info.render.frame++,at===!0&&ft.beginShadows();let q=d.state.shadowsArray;xt.render(q,E,B),at===!0&&ft.endShadows(),this.info.autoReset===!0&&this.info.reset();let Y=m.opaque,H=m.transmissive;if(d.setupLights(),B.isArrayCamera){let ht=B.cameras;if(H.length>0)for(let bt=0,Ot=ht.length;bt<Ot;bt++){let Lt=ht[bt];qi(Y,H,E,Lt)}Kt&&Nt.render(E);for(let bt=0,Ot=ht.length;bt<Ot;bt++){let Lt=ht[bt];Xi(m,E,Lt,Lt.viewport)}}else H.length>0&&qi(Y,H,E,B),Kt&&Nt.render(E),Xi(m,E,B);O!==null&&(P.updateMultisampleRenderTarget(O),P.updateRenderTargetMipmap(O)),E.isScene===!0&&E.onAfterRender(y,E,B),de.resetDefaultState(),A=-1,S=null,b.pop(),b.length>0?(d=b[b.length-1],at===!0&&ft.setGlobalState(y.clippingPlanes,d.state.camera)):d=null,M.pop(),M.length>0?m=M[M.length-1]:m=null};function xn(E,B,q,Y){if(E.visible===!1)return;if(E.layers.test(B.layers)){if(E.isGroup)q=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(B);else if(E.isLight)d.pushLight(E),E.castShadow&&d.pushShadow(E);else if(E.isSprite){if(!E.frustumCulled||it.intersectsSprite(E)){Y&&Ut.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Bt);let bt=et.update(E),Ot=E.material;Ot.visible&&m.push(E,bt,Ot,q,Ut.z,null)}}else if((E.isMesh||E.isLine||E.isPoints)&&(!E.frustumCulled||it.intersectsObject(E))){let bt=et.update(E),Ot=E.material;if(Y&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Ut.copy(E.boundingSphere.center)):(bt.boundingSphere===null&&bt.computeBoundingSphere(),Ut.copy(bt.boundingSphere.center)),Ut.applyMatrix4(E.matrixWorld).applyMatrix4(Bt)),Array.isArray(Ot)){let Lt=bt.groups;for(let Wt=0,qt=Lt.length;Wt<qt;Wt++){let Dt=Lt[Wt],oe=Ot[Dt.materialIndex];oe&&oe.visible&&m.push(E,bt,oe,q,Ut.z,Dt)}}else Ot.visible&&m.push(E,bt,Ot,q,Ut.z,null)}}let ht=E.children;for(let bt=0,Ot=ht.length;bt<Ot;bt++)xn(ht[bt],B,q,Y)}function Xi(E,B,q,Y){let H=E.opaque,ht=E.transmissive,bt=E.transparent;d.setupLightsView(q),at===!0&&ft.setGlobalState(y.clippingPlanes,q),Y&&Gt.viewport(R.copy(Y)),H.length>0&&Ps(H,B,q),ht.length>0&&Ps(ht,B,q),bt.length>0&&Ps(bt,B,q),Gt.buffers.depth.setTest(!0),Gt.buffers.depth.setMask(!0),Gt.buffers.color.setMask(!0),Gt.setPolygonOffset(!1)}function qi(E,B,q,Y){if((q.isScene===!0?q.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[Y.id]===void 0&&(d.state.transmissionRenderTarget[Y.id]=new as(1,1,{generateMipmaps:!0,type:te.has("EXT_color_buffer_half_float")||te.has("EXT_color_buffer_float")?jo:rs,minFilter:Qs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:le.workingColorSpace}));let ht=d.state.transmissionRenderTarget[Y.id],bt=Y.viewport||R;ht.setSize(bt.z,bt.w);let Ot=y.getRenderTarget();y.setRenderTarget(ht),y.getClearColor(W),J=y.getClearAlpha(),J<1&&y.setClearColor(16777215,.5),y.clear(),Kt&&Nt.render(q);let Lt=y.toneMapping;y.toneMapping=Es;let Wt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),d.setupLightsView(Y),at===!0&&ft.setGlobalState(y.clippingPlanes,Y),Ps(E,q,Y),P.updateMultisampleRenderTarget(ht),P.updateRenderTargetMipmap(ht),te.has("WEBGL_multisampled_render_to_texture")===!1){let qt=!1;for(let Dt=0,oe=B.length;Dt<oe;Dt++){let ve=B[Dt],Se=ve.object,ln=ve.geometry,ue=ve.material,kt=ve.group;if(ue.side===bi&&Se.layers.test(Y.layers)){let ke=ue.side;ue.side=kn,ue.needsUpdate=!0,mo(Se,q,Y,ln,ue,kt),ue.side=ke,ue.needsUpdate=!0,qt=!0}}qt===!0&&(P.updateMultisampleRenderTarget(ht),P.updateRenderTargetMipmap(ht))}y.setRenderTarget(Ot),y.setClearColor(W,J),Wt!==void 0&&(Y.viewport=Wt),y.toneMapping=Lt}function Ps(E,B,q){let Y=B.isScene===!0?B.overrideMaterial:null;for(let H=0,ht=E.length;H<ht;H++){let bt=E[H],Ot=bt.object,Lt=bt.geometry,Wt=Y===null?bt.material:Y,qt=bt.group;Ot.layers.test(q.layers)&&mo(Ot,B,q,Lt,Wt,qt)}}function mo(E,B,q,Y,H,ht){E.onBeforeRender(y,B,q,Y,H,ht),E.modelViewMatrix.multiplyMatrices(q.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),H.onBeforeRender(y,B,q,Y,E,ht),H.transparent===!0&&H.side===bi&&H.forceSinglePass===!1?(H.side=kn,H.needsUpdate=!0,y.renderBufferDirect(q,B,Y,H,E,ht),H.side=As,H.needsUpdate=!0,y.renderBufferDirect(q,B,Y,H,E,ht),H.side=bi):y.renderBufferDirect(q,B,Y,H,E,ht),E.onAfterRender(y,B,q,Y,H,ht)}function lr(E,B,q){B.isScene!==!0&&(B=ce);let Y=Pt.get(E),H=d.state.lights,ht=d.state.shadowsArray,bt=H.state.version,Ot=Mt.getParameters(E,H.state,ht,B,q),Lt=Mt.getProgramCacheKey(Ot),Wt=Y.programs;Y.environment=E.isMeshStandardMaterial?B.environment:null,Y.fog=B.fog,Y.envMap=(E.isMeshStandardMaterial?Z:w).get(E.envMap||Y.environment),Y.envMapRotation=Y.environment!==null&&E.envMap===null?B.environmentRotation:E.envMapRotation,Wt===void 0&&(E.addEventListener("dispose",Jt),Wt=new Map,Y.programs=Wt);let qt=Wt.get(Lt);if(qt!==void 0){if(Y.currentProgram===qt&&Y.lightsStateVersion===bt)return Pi(E,Ot),qt}else Ot.uniforms=Mt.getUniforms(E),E.onBeforeCompile(Ot,y),qt=Mt.acquireProgram(Ot,Lt),Wt.set(Lt,qt),Y.uniforms=Ot.uniforms;let Dt=Y.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Dt.clippingPlanes=ft.uniform),Pi(E,Ot),Y.needsLights=aa(E),Y.lightsStateVersion=bt,Y.needsLights&&(Dt.ambientLightColor.value=H.state.ambient,Dt.lightProbe.value=H.state.probe,Dt.directionalLights.value=H.state.directional,Dt.directionalLightShadows.value=H.state.directionalShadow,Dt.spotLights.value=H.state.spot,Dt.spotLightShadows.value=H.state.spotShadow,Dt.rectAreaLights.value=H.state.rectArea,Dt.ltc_1.value=H.state.rectAreaLTC1,Dt.ltc_2.value=H.state.rectAreaLTC2,Dt.pointLights.value=H.state.point,Dt.pointLightShadows.value=H.state.pointShadow,Dt.hemisphereLights.value=H.state.hemi,Dt.directionalShadowMap.value=H.state.directionalShadowMap,Dt.directionalShadowMatrix.value=H.state.directionalShadowMatrix,Dt.spotShadowMap.value=H.state.spotShadowMap,Dt.spotLightMatrix.value=H.state.spotLightMatrix,Dt.spotLightMap.value=H.state.spotLightMap,Dt.pointShadowMap.value=H.state.pointShadowMap,Dt.pointShadowMatrix.value=H.state.pointShadowMatrix),Y.currentProgram=qt,Y.uniformsList=null,qt}function oa(E){if(E.uniformsList===null){let B=E.currentProgram.getUniforms();E.uniformsList=jr.seqWithValue(B.seq,E.uniforms)}return E.uniformsList}function Pi(E,B){let q=Pt.get(E);q.outputColorSpace=B.outputColorSpace,q.batching=B.batching,q.batchingColor=B.batchingColor,q.instancing=B.instancing,q.instancingColor=B.instancingColor,q.instancingMorph=B.instancingMorph,q.skinning=B.skinning,q.morphTargets=B.morphTargets,q.morphNormals=B.morphNormals,q.morphColors=B.morphColors,q.morphTargetsCount=B.morphTargetsCount,q.numClippingPlanes=B.numClippingPlanes,q.numIntersection=B.numClipIntersection,q.vertexAlphas=B.vertexAlphas,q.vertexTangents=B.vertexTangents,q.toneMapping=B.toneMapping}function hc(E,B,q,Y,H){B.isScene!==!0&&(B=ce),P.resetTextureUnits();let ht=B.fog,bt=Y.isMeshStandardMaterial?B.environment:null,Ot=O===null?y.outputColorSpace:O.isXRRenderTarget===!0?O.texture.colorSpace:co,Lt=(Y.isMeshStandardMaterial?Z:w).get(Y.envMap||bt),Wt=Y.vertexColors===!0&&!!q.attributes.color&&q.attributes.color.itemSize===4,qt=!!q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Dt=!!q.morphAttributes.position,oe=!!q.morphAttributes.normal,ve=!!q.morphAttributes.color,Se=Es;Y.toneMapped&&(O===null||O.isXRRenderTarget===!0)&&(Se=y.toneMapping);let ln=q.morphAttributes.position||q.morphAttributes.normal||q.morphAttributes.color,ue=ln!==void 0?ln.length:0,kt=Pt.get(Y),ke=d.state.lights;if(at===!0&&(gt===!0||E!==S)){let En=E===S&&Y.id===A;ft.setState(Y,E,En)}let pe=!1;Y.version===kt.__version?(kt.needsLights&&kt.lightsStateVersion!==ke.state.version||kt.outputColorSpace!==Ot||H.isBatchedMesh&&kt.batching===!1||!H.isBatchedMesh&&kt.batching===!0||H.isBatchedMesh&&kt.batchingColor===!0&&H.colorTexture===null||H.isBatchedMesh&&kt.batchingColor===!1&&H.colorTexture!==null||H.isInstancedMesh&&kt.instancing===!1||!H.isInstancedMesh&&kt.instancing===!0||H.isSkinnedMesh&&kt.skinning===!1||!H.isSkinnedMesh&&kt.skinning===!0||H.isInstancedMesh&&kt.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&kt.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&kt.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&kt.instancingMorph===!1&&H.morphTexture!==null||kt.envMap!==Lt||Y.fog===!0&&kt.fog!==ht||kt.numClippingPlanes!==void 0&&(kt.numClippingPlanes!==ft.numPlanes||kt.numIntersection!==ft.numIntersection)||kt.vertexAlphas!==Wt||kt.vertexTangents!==qt||kt.morphTargets!==Dt||kt.morphNormals!==oe||kt.morphColors!==ve||kt.toneMapping!==Se||kt.morphTargetsCount!==ue)&&(pe=!0):(pe=!0,kt.__version=Y.version);let On=kt.currentProgram;pe===!0&&(On=lr(Y,B,H));let Ii=!1,yn=!1,Ls=!1,Te=On.getUniforms(),ei=kt.uniforms;if(Gt.useProgram(On.program)&&(Ii=!0,yn=!0,Ls=!0),Y.id!==A&&(A=Y.id,yn=!0),Ii||S!==E){Gt.buffers.depth.getReversed()?(ot.copy(E.projectionMatrix),wv(ot),Ev(ot),Te.setValue(V,"projectionMatrix",ot)):Te.setValue(V,"projectionMatrix",E.projectionMatrix),Te.setValue(V,"viewMatrix",E.matrixWorldInverse);let Li=Te.map.cameraPosition;Li!==void 0&&Li.setValue(V,Ht.setFromMatrixPosition(E.matrixWorld)),ee.logarithmicDepthBuffer&&Te.setValue(V,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&Te.setValue(V,"isOrthographic",E.isOrthographicCamera===!0),S!==E&&(S=E,yn=!0,Ls=!0)}if(H.isSkinnedMesh){Te.setOptional(V,H,"bindMatrix"),Te.setOptional(V,H,"bindMatrixInverse");let En=H.skeleton;En&&(En.boneTexture===null&&En.computeBoneTexture(),Te.setValue(V,"boneTexture",En.boneTexture,P))}H.isBatchedMesh&&(Te.setOptional(V,H,"batchingTexture"),Te.setValue(V,"batchingTexture",H._matricesTexture,P),Te.setOptional(V,H,"batchingIdTexture"),Te.setValue(V,"batchingIdTexture",H._indirectTexture,P),Te.setOptional(V,H,"batchingColorTexture"),H._colorsTexture!==null&&Te.setValue(V,"batchingColorTexture",H._colorsTexture,P));let ls=q.morphAttributes;if((ls.position!==void 0||ls.normal!==void 0||ls.color!==void 0)&&Ft.update(H,q,On),(yn||kt.receiveShadow!==H.receiveShadow)&&(kt.receiveShadow=H.receiveShadow,Te.setValue(V,"receiveShadow",H.receiveShadow)),Y.isMeshGouraudMaterial&&Y.envMap!==null&&(ei.envMap.value=Lt,ei.flipEnvMap.value=Lt.isCubeTexture&&Lt.isRenderTargetTexture===!1?-1:1),Y.isMeshStandardMaterial&&Y.envMap===null&&B.environment!==null&&(ei.envMapIntensity.value=B.environmentIntensity),yn&&(Te.setValue(V,"toneMappingExposure",y.toneMappingExposure),kt.needsLights&&Is(ei,Ls),ht&&Y.fog===!0&&_t.refreshFogUniforms(ei,ht),_t.refreshMaterialUniforms(ei,Y,tt,Q,d.state.transmissionRenderTarget[E.id]),jr.upload(V,oa(kt),ei,P)),Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(jr.upload(V,oa(kt),ei,P),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&Te.setValue(V,"center",H.center),Te.setValue(V,"modelViewMatrix",H.modelViewMatrix),Te.setValue(V,"normalMatrix",H.normalMatrix),Te.setValue(V,"modelMatrix",H.matrixWorld),Y.isShaderMaterial||Y.isRawShaderMaterial){let En=Y.uniformsGroups;for(let Li=0,fi=En.length;Li<fi;Li++){let cr=En[Li];z.update(cr,On),z.bind(cr,On)}}return On}function Is(E,B){E.ambientLightColor.needsUpdate=B,E.lightProbe.needsUpdate=B,E.directionalLights.needsUpdate=B,E.directionalLightShadows.needsUpdate=B,E.pointLights.needsUpdate=B,E.pointLightShadows.needsUpdate=B,E.spotLights.needsUpdate=B,E.spotLightShadows.needsUpdate=B,E.rectAreaLights.needsUpdate=B,E.hemisphereLights.needsUpdate=B}function aa(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return C},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return O},this.setRenderTargetTextures=function(E,B,q){Pt.get(E.texture).__webglTexture=B,Pt.get(E.depthTexture).__webglTexture=q;let Y=Pt.get(E);Y.__hasExternalTextures=!0,Y.__autoAllocateDepthBuffer=q===void 0,Y.__autoAllocateDepthBuffer||te.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),Y.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(E,B){let q=Pt.get(E);q.__webglFramebuffer=B,q.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(E,B=0,q=0){O=E,C=B,D=q;let Y=!0,H=null,ht=!1,bt=!1;if(E){let Lt=Pt.get(E);if(Lt.__useDefaultFramebuffer!==void 0)Gt.bindFramebuffer(V.FRAMEBUFFER,null),Y=!1;else if(Lt.__webglFramebuffer===void 0)P.setupRenderTarget(E);else if(Lt.__hasExternalTextures)P.rebindTextures(E,Pt.get(E.texture).__webglTexture,Pt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let Dt=E.depthTexture;if(Lt.__boundDepthTexture!==Dt){if(Dt!==null&&Pt.has(Dt)&&(E.width!==Dt.image.width||E.height!==Dt.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");P.setupDepthRenderbuffer(E)}}let Wt=E.texture;(Wt.isData3DTexture||Wt.isDataArrayTexture||Wt.isCompressedArrayTexture)&&(bt=!0);let qt=Pt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(qt[B])?H=qt[B][q]:H=qt[B],ht=!0):E.samples>0&&P.useMultisampledRTT(E)===!1?H=Pt.get(E).__webglMultisampledFramebuffer:Array.isArray(qt)?H=qt[q]:H=qt,R.copy(E.viewport),G.copy(E.scissor),F=E.scissorTest}else R.copy(mt).multiplyScalar(tt).floor(),G.copy(vt).multiplyScalar(tt).floor(),F=pt;if(Gt.bindFramebuffer(V.FRAMEBUFFER,H)&&Y&&Gt.drawBuffers(E,H),Gt.viewport(R),Gt.scissor(G),Gt.setScissorTest(F),ht){let Lt=Pt.get(E.texture);V.framebufferTexture2D(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,V.TEXTURE_CUBE_MAP_POSITIVE_X+B,Lt.__webglTexture,q)}else if(bt){let Lt=Pt.get(E.texture),Wt=B||0;V.framebufferTextureLayer(V.FRAMEBUFFER,V.COLOR_ATTACHMENT0,Lt.__webglTexture,q||0,Wt)}A=-1},this.readRenderTargetPixels=function(E,B,q,Y,H,ht,bt){if(!(E&&E.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ot=Pt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&bt!==void 0&&(Ot=Ot[bt]),Ot){Gt.bindFramebuffer(V.FRAMEBUFFER,Ot);try{let Lt=E.texture,Wt=Lt.format,qt=Lt.type;if(!ee.textureFormatReadable(Wt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!ee.textureTypeReadable(qt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=E.width-Y&&q>=0&&q<=E.height-H&&V.readPixels(B,q,Y,H,Yt.convert(Wt),Yt.convert(qt),ht)}finally{let Lt=O!==null?Pt.get(O).__webglFramebuffer:null;Gt.bindFramebuffer(V.FRAMEBUFFER,Lt)}}},this.readRenderTargetPixelsAsync=async function(E,B,q,Y,H,ht,bt){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ot=Pt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&bt!==void 0&&(Ot=Ot[bt]),Ot){let Lt=E.texture,Wt=Lt.format,qt=Lt.type;if(!ee.textureFormatReadable(Wt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!ee.textureTypeReadable(qt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(B>=0&&B<=E.width-Y&&q>=0&&q<=E.height-H){Gt.bindFramebuffer(V.FRAMEBUFFER,Ot);let Dt=V.createBuffer();V.bindBuffer(V.PIXEL_PACK_BUFFER,Dt),V.bufferData(V.PIXEL_PACK_BUFFER,ht.byteLength,V.STREAM_READ),V.readPixels(B,q,Y,H,Yt.convert(Wt),Yt.convert(qt),0);let oe=O!==null?Pt.get(O).__webglFramebuffer:null;Gt.bindFramebuffer(V.FRAMEBUFFER,oe);let ve=V.fenceSync(V.SYNC_GPU_COMMANDS_COMPLETE,0);return V.flush(),await Sv(V,ve,4),V.bindBuffer(V.PIXEL_PACK_BUFFER,Dt),V.getBufferSubData(V.PIXEL_PACK_BUFFER,0,ht),V.deleteBuffer(Dt),V.deleteSync(ve),ht}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(E,B=null,q=0){E.isTexture!==!0&&(Ho("WebGLRenderer: copyFramebufferToTexture function signature has changed."),B=arguments[0]||null,E=arguments[1]);let Y=Math.pow(2,-q),H=Math.floor(E.image.width*Y),ht=Math.floor(E.image.height*Y),bt=B!==null?B.x:0,Ot=B!==null?B.y:0;P.setTexture2D(E,0),V.copyTexSubImage2D(V.TEXTURE_2D,q,0,0,bt,Ot,H,ht),Gt.unbindTexture()},this.copyTextureToTexture=function(E,B,q=null,Y=null,H=0){E.isTexture!==!0&&(Ho("WebGLRenderer: copyTextureToTexture function signature has changed."),Y=arguments[0]||null,E=arguments[1],B=arguments[2],H=arguments[3]||0,q=null);let ht,bt,Ot,Lt,Wt,qt,Dt,oe,ve,Se=E.isCompressedTexture?E.mipmaps[H]:E.image;q!==null?(ht=q.max.x-q.min.x,bt=q.max.y-q.min.y,Ot=q.isBox3?q.max.z-q.min.z:1,Lt=q.min.x,Wt=q.min.y,qt=q.isBox3?q.min.z:0):(ht=Se.width,bt=Se.height,Ot=Se.depth||1,Lt=0,Wt=0,qt=0),Y!==null?(Dt=Y.x,oe=Y.y,ve=Y.z):(Dt=0,oe=0,ve=0);let ln=Yt.convert(B.format),ue=Yt.convert(B.type),kt;B.isData3DTexture?(P.setTexture3D(B,0),kt=V.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(P.setTexture2DArray(B,0),kt=V.TEXTURE_2D_ARRAY):(P.setTexture2D(B,0),kt=V.TEXTURE_2D),V.pixelStorei(V.UNPACK_FLIP_Y_WEBGL,B.flipY),V.pixelStorei(V.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),V.pixelStorei(V.UNPACK_ALIGNMENT,B.unpackAlignment);let ke=V.getParameter(V.UNPACK_ROW_LENGTH),pe=V.getParameter(V.UNPACK_IMAGE_HEIGHT),On=V.getParameter(V.UNPACK_SKIP_PIXELS),Ii=V.getParameter(V.UNPACK_SKIP_ROWS),yn=V.getParameter(V.UNPACK_SKIP_IMAGES);V.pixelStorei(V.UNPACK_ROW_LENGTH,Se.width),V.pixelStorei(V.UNPACK_IMAGE_HEIGHT,Se.height),V.pixelStorei(V.UNPACK_SKIP_PIXELS,Lt),V.pixelStorei(V.UNPACK_SKIP_ROWS,Wt),V.pixelStorei(V.UNPACK_SKIP_IMAGES,qt);let Ls=E.isDataArrayTexture||E.isData3DTexture,Te=B.isDataArrayTexture||B.isData3DTexture;if(E.isRenderTargetTexture||E.isDepthTexture){let ei=Pt.get(E),ls=Pt.get(B),En=Pt.get(ei.__renderTarget),Li=Pt.get(ls.__renderTarget);Gt.bindFramebuffer(V.READ_FRAMEBUFFER,En.__webglFramebuffer),Gt.bindFramebuffer(V.DRAW_FRAMEBUFFER,Li.__webglFramebuffer);for(let fi=0;fi<Ot;fi++)Ls&&V.framebufferTextureLayer(V.READ_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Pt.get(E).__webglTexture,H,qt+fi),E.isDepthTexture?(Te&&V.framebufferTextureLayer(V.DRAW_FRAMEBUFFER,V.COLOR_ATTACHMENT0,Pt.get(B).__webglTexture,H,ve+fi),V.blitFramebuffer(Lt,Wt,ht,bt,Dt,oe,ht,bt,V.DEPTH_BUFFER_BIT,V.NEAREST)):Te?V.copyTexSubImage3D(kt,H,Dt,oe,ve+fi,Lt,Wt,ht,bt):V.copyTexSubImage2D(kt,H,Dt,oe,ve+fi,Lt,Wt,ht,bt);Gt.bindFramebuffer(V.READ_FRAMEBUFFER,null),Gt.bindFramebuffer(V.DRAW_FRAMEBUFFER,null)}else Te?E.isDataTexture||E.isData3DTexture?V.texSubImage3D(kt,H,Dt,oe,ve,ht,bt,Ot,ln,ue,Se.data):B.isCompressedArrayTexture?V.compressedTexSubImage3D(kt,H,Dt,oe,ve,ht,bt,Ot,ln,Se.data):V.texSubImage3D(kt,H,Dt,oe,ve,ht,bt,Ot,ln,ue,Se):E.isDataTexture?V.texSubImage2D(V.TEXTURE_2D,H,Dt,oe,ht,bt,ln,ue,Se.data):E.isCompressedTexture?V.compressedTexSubImage2D(V.TEXTURE_2D,H,Dt,oe,Se.width,Se.height,ln,Se.data):V.texSubImage2D(V.TEXTURE_2D,H,Dt,oe,ht,bt,ln,ue,Se);V.pixelStorei(V.UNPACK_ROW_LENGTH,ke),V.pixelStorei(V.UNPACK_IMAGE_HEIGHT,pe),V.pixelStorei(V.UNPACK_SKIP_PIXELS,On),V.pixelStorei(V.UNPACK_SKIP_ROWS,Ii),V.pixelStorei(V.UNPACK_SKIP_IMAGES,yn),H===0&&B.generateMipmaps&&V.generateMipmap(kt),Gt.unbindTexture()},this.copyTextureToTexture3D=function(E,B,q=null,Y=null,H=0){return E.isTexture!==!0&&(Ho("WebGLRenderer: copyTextureToTexture3D function signature has changed."),q=arguments[0]||null,Y=arguments[1]||null,E=arguments[2],B=arguments[3],H=arguments[4]||0),Ho('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(E,B,q,Y,H)},this.initRenderTarget=function(E){Pt.get(E).__webglFramebuffer===void 0&&P.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?P.setTextureCube(E,0):E.isData3DTexture?P.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?P.setTexture2DArray(E,0):P.setTexture2D(E,0),Gt.unbindTexture()},this.resetState=function(){C=0,D=0,O=null,Gt.reset(),de.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return is}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorspace=le._getDrawingBufferColorSpace(t),e.unpackColorSpace=le._getUnpackColorSpace()}};var Ll=class extends wn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ai,this.environmentIntensity=1,this.environmentRotation=new Ai,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};var Zu=class extends er{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new se(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Dl=new L,Ul=new L,rg=new He,Vo=new ro,cl=new so,Xh=new L,og=new L,Ku=class extends wn{constructor(t=new nn,e=new Zu){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Dl.fromBufferAttribute(e,s-1),Ul.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Dl.distanceTo(Ul);t.setAttribute("lineDistance",new _n(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),cl.copy(n.boundingSphere),cl.applyMatrix4(s),cl.radius+=r,t.ray.intersectsSphere(cl)===!1)return;rg.copy(s).invert(),Vo.copy(t.ray).applyMatrix4(rg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let p=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let x=p,m=g-1;x<m;x+=c){let d=h.getX(x),M=h.getX(x+1),b=hl(this,t,Vo,l,d,M);b&&e.push(b)}if(this.isLineLoop){let x=h.getX(g-1),m=h.getX(p),d=hl(this,t,Vo,l,x,m);d&&e.push(d)}}else{let p=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let x=p,m=g-1;x<m;x+=c){let d=hl(this,t,Vo,l,x,x+1);d&&e.push(d)}if(this.isLineLoop){let x=hl(this,t,Vo,l,g-1,p);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function hl(i,t,e,n,s,r){let o=i.geometry.attributes.position;if(Dl.fromBufferAttribute(o,s),Ul.fromBufferAttribute(o,r),e.distanceSqToSegment(Dl,Ul,Xh,og)>n)return;Xh.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(Xh);if(!(l<t.near||l>t.far))return{distance:l,point:og.clone().applyMatrix4(i.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:i}}var ag=new L,lg=new L,Nl=class extends Ku{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)ag.fromBufferAttribute(e,s),lg.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+ag.distanceTo(lg);t.setAttribute("lineDistance",new _n(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Bn=class extends nn{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],p=[],g=0,x=[],m=n/2,d=0;M(),o===!1&&(t>0&&b(!0),e>0&&b(!1)),this.setIndex(h),this.setAttribute("position",new _n(u,3)),this.setAttribute("normal",new _n(f,3)),this.setAttribute("uv",new _n(p,2));function M(){let y=new L,U=new L,C=0,D=(e-t)/n;for(let O=0;O<=r;O++){let A=[],S=O/r,R=S*(e-t)+t;for(let G=0;G<=s;G++){let F=G/s,W=F*l+a,J=Math.sin(W),K=Math.cos(W);U.x=R*J,U.y=-S*n+m,U.z=R*K,u.push(U.x,U.y,U.z),y.set(J,D,K).normalize(),f.push(y.x,y.y,y.z),p.push(F,1-S),A.push(g++)}x.push(A)}for(let O=0;O<s;O++)for(let A=0;A<r;A++){let S=x[A][O],R=x[A+1][O],G=x[A+1][O+1],F=x[A][O+1];(t>0||A!==0)&&(h.push(S,R,F),C+=3),(e>0||A!==r-1)&&(h.push(R,G,F),C+=3)}c.addGroup(d,C,0),d+=C}function b(y){let U=g,C=new Qt,D=new L,O=0,A=y===!0?t:e,S=y===!0?1:-1;for(let G=1;G<=s;G++)u.push(0,m*S,0),f.push(0,S,0),p.push(.5,.5),g++;let R=g;for(let G=0;G<=s;G++){let W=G/s*l+a,J=Math.cos(W),K=Math.sin(W);D.x=A*K,D.y=m*S,D.z=A*J,u.push(D.x,D.y,D.z),f.push(0,S,0),C.x=J*.5+.5,C.y=K*.5*S+.5,p.push(C.x,C.y),g++}for(let G=0;G<s;G++){let F=U+G,W=R+G;y===!0?h.push(W,W+1,F):h.push(W+1,W,F),O+=3}c.addGroup(d,O,y===!0?1:2),d+=O}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Bn(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Vi=class extends Bn{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new Vi(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var nr=class extends nn{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new L,f=new L,p=[],g=[],x=[],m=[];for(let d=0;d<=n;d++){let M=[],b=d/n,y=0;d===0&&o===0?y=.5/e:d===n&&l===Math.PI&&(y=-.5/e);for(let U=0;U<=e;U++){let C=U/e;u.x=-t*Math.cos(s+C*r)*Math.sin(o+b*a),u.y=t*Math.cos(o+b*a),u.z=t*Math.sin(s+C*r)*Math.sin(o+b*a),g.push(u.x,u.y,u.z),f.copy(u).normalize(),x.push(f.x,f.y,f.z),m.push(C+y,1-b),M.push(c++)}h.push(M)}for(let d=0;d<n;d++)for(let M=0;M<e;M++){let b=h[d][M+1],y=h[d][M],U=h[d+1][M],C=h[d+1][M+1];(d!==0||o>0)&&p.push(b,y,C),(d!==n-1||l<Math.PI)&&p.push(y,U,C)}this.setIndex(p),this.setAttribute("position",new _n(g,3)),this.setAttribute("normal",new _n(x,3)),this.setAttribute("uv",new _n(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new nr(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ko=class extends Ti{static get type(){return"RawShaderMaterial"}constructor(t){super(t),this.isRawShaderMaterial=!0}};function ul(i,t,e){return!i||!e&&i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function y1(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var lo=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},Ju=class extends lo{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:cm,endingEnd:cm}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case hm:r=t,a=2*e-n;break;case um:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case hm:o=t,l=2*n-e;break;case um:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,p=this._weightNext,g=(n-e)/(s-e),x=g*g,m=x*g,d=-f*m+2*f*x-f*g,M=(1+f)*m+(-1.5-2*f)*x+(-.5+f)*g+1,b=(-1-p)*m+(1.5+p)*x+.5*g,y=p*m-p*x;for(let U=0;U!==a;++U)r[U]=d*o[h+U]+M*o[c+U]+b*o[l+U]+y*o[u+U];return r}},ju=class extends lo{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},Qu=class extends lo{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Ci=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ul(e,this.TimeBufferType),this.values=ul(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:ul(t.times,Array),values:ul(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s)}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Qu(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new ju(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ju(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let e;switch(t){case _l:e=this.InterpolantFactoryMethodDiscrete;break;case Iu:e=this.InterpolantFactoryMethodLinear;break;case xh:e=this.InterpolantFactoryMethodSmooth;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return _l;case this.InterpolantFactoryMethodLinear:return Iu;case this.InterpolantFactoryMethodSmooth:return xh}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&y1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===xh,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,f=u-n,p=u+n;for(let g=0;g!==n;++g){let x=e[u+g];if(x!==e[f+g]||x!==e[p+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,f=o*n;for(let p=0;p!==n;++p)e[f+p]=e[u+p]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,s}};Ci.prototype.TimeBufferType=Float32Array;Ci.prototype.ValueBufferType=Float32Array;Ci.prototype.DefaultInterpolation=Iu;var ir=class extends Ci{constructor(t,e,n){super(t,e,n)}};ir.prototype.ValueTypeName="bool";ir.prototype.ValueBufferType=Array;ir.prototype.DefaultInterpolation=_l;ir.prototype.InterpolantFactoryMethodLinear=void 0;ir.prototype.InterpolantFactoryMethodSmooth=void 0;var tf=class extends Ci{};tf.prototype.ValueTypeName="color";var ef=class extends Ci{};ef.prototype.ValueTypeName="number";var nf=class extends lo{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Pe.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ol=class extends Ci{InterpolantFactoryMethodLinear(t){return new nf(this.times,this.values,this.getValueSize(),t)}};Ol.prototype.ValueTypeName="quaternion";Ol.prototype.InterpolantFactoryMethodSmooth=void 0;var sr=class extends Ci{constructor(t,e,n){super(t,e,n)}};sr.prototype.ValueTypeName="string";sr.prototype.ValueBufferType=Array;sr.prototype.DefaultInterpolation=_l;sr.prototype.InterpolantFactoryMethodLinear=void 0;sr.prototype.InterpolantFactoryMethodSmooth=void 0;var sf=class extends Ci{};sf.prototype.ValueTypeName="vector";var rf=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let p=c[u],g=c[u+1];if(p.global&&(p.lastIndex=0),p.test(h))return g}return null}}},v1=new rf,of=class{constructor(t){this.manager=t!==void 0?t:v1,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}};of.DEFAULT_MATERIAL_NAME="__DEFAULT";var _f="\\[\\]\\.:\\/",M1=new RegExp("["+_f+"]","g"),xf="[^"+_f+"]",b1="[^"+_f.replace("\\.","")+"]",S1=/((?:WC+[\/:])*)/.source.replace("WC",xf),w1=/(WCOD+)?/.source.replace("WCOD",b1),E1=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",xf),A1=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",xf),T1=new RegExp("^"+S1+w1+E1+A1+"$"),C1=["material","materials","bones","map"],af=class{constructor(t,e,n){let s=n||be.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},be=class{constructor(t,e,n){this.path=e,this.parsedPath=n||be.parseTrackName(e),this.node=be.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new be.Composite(t,e,n):new be(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(M1,"")}static parseTrackName(t){let e=T1.exec(t);if(e===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);C1.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=be.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.needsUpdate!==void 0?a=this.Versioning.NeedsUpdate:t.matrixWorldNeedsUpdate!==void 0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};be.Composite=af;be.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};be.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};be.prototype.GetterByBindingType=[be.prototype._getValue_direct,be.prototype._getValue_array,be.prototype._getValue_arrayElement,be.prototype._getValue_toArray];be.prototype.SetterByBindingTypeAndVersioning=[[be.prototype._setValue_direct,be.prototype._setValue_direct_setNeedsUpdate,be.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[be.prototype._setValue_array,be.prototype._setValue_array_setNeedsUpdate,be.prototype._setValue_array_setMatrixWorldNeedsUpdate],[be.prototype._setValue_arrayElement,be.prototype._setValue_arrayElement_setNeedsUpdate,be.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[be.prototype._setValue_fromArray,be.prototype._setValue_fromArray_setNeedsUpdate,be.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var yA=new Float32Array(1);var Jo=class{constructor(t=1,e=0,n=0){return this.radius=t,this.phi=e,this.theta=n,this}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Math.max(1e-6,Math.min(Math.PI-1e-6,this.phi)),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(bn(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Fl=class extends os{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(){}disconnect(){}dispose(){}update(){}};typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:lf}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=lf);le.enabled=!1;var R1=`
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform mat3 normalMatrix;
in vec3 position, normal, color;
out vec3 place, side, paint;
void main() {
  vec4 p = modelViewMatrix * vec4(position, 1.0);
  place = p.xyz;
  side = normalMatrix * normal;
  paint = color;
  gl_Position = projectionMatrix * p;
}`,P1=`
precision highp float;
uniform vec3 tint;
uniform float flat_sides;
in vec3 place, side, paint;
out vec4 colour;
void main() {
  vec3 n = normalize(flat_sides > 0.5 ? cross(dFdx(place), dFdy(place)) : side);
  if (dot(n, place) > 0.0) n = -n;
  float light = 0.52 + 0.46 * max(dot(n, vec3(-0.36, 0.57, 0.74)), 0.0) + 0.14 * max(dot(n, vec3(0.78, -0.45, 0.43)), 0.0);
  colour = vec4(tint * paint * light, 1.0);
}`,I1=`
precision mediump float;
uniform vec3 tint;
uniform float alpha;
out vec4 colour;
void main() { colour = vec4(tint, alpha); }`,L1=`
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;function Qn(i=16777215,t=!1){return new Ko({glslVersion:$o,vertexShader:R1,fragmentShader:P1,side:bi,uniforms:{tint:{value:new se(i)},flat_sides:{value:t?1:0}}})}function Lg(i,t){return new Ko({glslVersion:$o,vertexShader:L1,fragmentShader:I1,transparent:!0,uniforms:{tint:{value:new se(i)},alpha:{value:t}}})}var D1=.3,U1=.004,N1=new L(0,1,0),Vl=new L,yf=new L,Dg=new Pe;function Ug({cases:i,load:t}){let e=li(t,i.reduce((s,r)=>s+r.nodes,0)),n=0;return i.map(s=>{let r={...s,load:new Float32Array(6*s.nodes),places:s.places&&qe(s.places),largest:0,moment:0};for(let o=0;o<s.nodes;++o,++n){let a=e.map(l=>l[n]);r.load.set(a,6*o),r.largest=Math.max(r.largest,Math.hypot(...a.slice(0,3))),r.moment=Math.max(r.moment,Math.hypot(...a.slice(3)))}return r})}var Qo=class{constructor(t){this.view=t;let e=.0035*t.size;this.head=5*e,this.material=Qn(13124923),this.shaft=new Bn(e,e,1,8).translate(0,.5,0),this.tip=new Vi(2.4*e,this.head,12).translate(0,.5*this.head,0),this.mesh=new Jn,this.arrows=[],t.scene.add(this.mesh),t.arrows=this}put(t,e,n,s){t===this.arrows.length&&(this.arrows.push([new Le(this.shaft,this.material),new Le(this.tip,this.material)]),this.mesh.add(...this.arrows[t]));let[r,o]=this.arrows[t],a=Math.max(s-this.head,.1*s),l=Math.min(1,s/this.head);r.quaternion.setFromUnitVectors(N1,n),o.quaternion.copy(r.quaternion),r.position.copy(e),r.scale.set(1,a,1),o.position.copy(e).addScaledVector(n,a),o.scale.setScalar(l)}end(t){for(let[e,n]of this.arrows.entries())for(let s of n)s.visible=e<t;this.view.canvas.dataset.arrows=t}},Hl=class extends Qo{constructor(t,e){super(t),this.unit=D1*t.size/Math.max(1e-300,...e.map(n=>n.largest)),this.parts=[]}show(t){this.parts=t,this.view.set({})}update(){let t=0;for(let e of this.parts){let n=this.view.byName.get(e.body);if(n)for(let s=0;s<e.nodes;++s){let r=O1(e,s,n);Vl.fromArray(e.load,6*s);let o=Vl.length()*this.unit;if(o<U1*this.view.size)continue;this.view.turn(e.body,n.elements.length?r:0,Dg),Vl.applyQuaternion(Dg).normalize();let a=e.places&&this.view.viewOf.get(e.body);if(a?.place)a.place(e.places,3*s,yf);else if(r<n.nodes)this.view.place(e.body,r,[0,0,0],0,yf);else continue;this.put(t++,yf,Vl,o)}}this.end(t)}};function O1(i,t,e){return i.nodes===e.nodes||!e.elements.length?t:Math.round(t*(e.nodes-1)/(i.nodes-1||1))}function Ng(i,t,e){let n=Ug(i.loads);if(!n.length)return null;let s=t?.view?new Hl(t.view,n):null,r=ga(n.map(m=>m.at),"s"),o=m=>e==="-"?`load factor ${Number(m.toPrecision(4))}`:r(m),a=N("div",{class:"controls row"}),l=N("tbody",{}),c=N("div",{class:"loads"},N("h3",{},"Loads"),a,N("div",{class:"scroll"},N("table",{id:"loads"},N("thead",{},N("tr",{},N("th",{},"part"),["at","largest force","largest moment"].map(m=>N("th",{class:"n"},m)))),l)),N("p",{class:"note"},"The equivalent static loads of the cycle at the instants where they, or the limit that bounds the design most, are largest. The arrows are the forces on the nodes of beams, on the interfaces of meshed parts and, as resultants of patches of the mesh, between them, drawn on the motion of the final design, all cycles to one scale.")),h=null,u=null,f=e!=="-",p=()=>[...new Set(n.filter(m=>m.cycle===u).map(m=>`${m.at}|${m.scenario}`))].map(m=>({at:Number(m.split("|")[0]),scenario:m.slice(m.indexOf("|")+1)})).sort((m,d)=>m.at-d.at),g=m=>p().reduce((d,M)=>d&&Math.abs(d.at-m)<=Math.abs(M.at-m)?d:M,null),x=m=>{m&&t?.toggle(!1),h=m;for(let d of a.querySelectorAll("button"))d.setAttribute("aria-pressed",String(!!m&&Number(d.dataset.at)===m.at&&d.dataset.scenario===m.scenario));s&&(s.show(m?n.filter(d=>d.cycle===u&&d.at===m.at&&d.scenario===m.scenario):[]),m&&t.clock.set(m.at))};return t?.clock.listen(m=>{h&&Math.abs(m-h.at)>1e-6*Math.abs(t.clock.last-t.clock.first)&&x(null)}),{node:c,largest:m=>Math.max(...n.filter(d=>d.cycle===m).map(d=>d.largest)),known:m=>n.some(d=>d.cycle===m),show(m){let d=h?.at;u=m,a.replaceChildren(...(s?p():[]).map(b=>N("button",{"data-at":b.at,"data-scenario":b.scenario,"aria-pressed":"false",title:"show the loads of this instant",onclick:()=>x(h&&h.at===b.at&&h.scenario===b.scenario?null:b)},o(b.at)+(b.scenario?` (${b.scenario})`:""))));let M=n.filter(b=>b.cycle===u);!M.length&&i.loads.thinned?l.replaceChildren(N("tr",{},N("td",{colspan:4},"left out of the page; those of every cycle are in cycle_loads.csv"))):l.replaceChildren(...M.map(b=>N("tr",{},N("td",{},b.body),N("td",{class:"n"},o(b.at)+(b.scenario?` (${b.scenario})`:"")),N("td",{class:"n"},zt(b.largest,"N")),N("td",{class:"n"},zt(b.moment,"N m"))))),x(d!==void 0?g(d):f||!s?null:g(t.clock.last)),f=!0}}}var F1={circle:["diameter"],tube:["diameter","thickness"],rectangle:["width","height"],box:["width","height","thickness"],I:["width","height","flange_thickness","web_thickness"]};function kg(i,t){let e=i.summary,n=e.history??[];if(n.length<1)return null;let s=n.map(M=>M.cycle),r=new gs(Float64Array.from(s));r.word=e.load_cases?"step":"cycle";let o=N("input",{type:"range",id:"cycle",min:0,max:n.length-1,step:1,value:n.length-1,oninput:()=>r.set(s[Number(o.value)])}),a=N("output",{for:"cycle"}),l=N("dl",{class:"figures"}),c=i.outlines.map(M=>V1(M)),h=B1(e,n),u=Ng(i,t,i.motion?.unit);r.listen(()=>{let M=Math.round(r.record()),b=n[M];o.value=M,a.textContent=`${r.word} ${b.cycle} of ${s[s.length-1]}`,l.replaceChildren(...k1(b,i)),u?.show(b.cycle),h?.show(b.design);for(let y of c)y.show(b.cycle,M===n.length-1);z1(i,t,b.design,M===n.length-1)});let p=n.every(M=>typeof M.objective=="number")?No(e.objective?.quantity??"objective",e.objective?.unit??"",s,n.map(M=>M.objective),r):No("mass","kg",s,n.map(M=>M.mass),r),g=Object.values(e.constraints??{}).some(yr),x=No(g?"worst limit, share or number above it":"worst limit, above it [%]","",s,n.map(M=>(g?1:100)*M.worst_constraint),r),m=u&&s.some(M=>u.known(M))?No("largest load","N",s,s.map(M=>u.known(M)?u.largest(M):NaN),r):null,d=Xe(r.word==="step"?"Steps":"Cycles",N("div",{class:"controls two"},o,a),N("div",{class:"split"},N("div",{},p,x,m),N("div",{},l,u?.node,...c.map(M=>M.node),h?.node)));return r.set(s[s.length-1]),d}function Og(i,t){return i?t.summary.load_cases?` in load case '${i}'`:` at ${i}`:""}function k1(i,t){let e=t.summary,n=[],s=(o,a)=>n.push(N("dt",{},o),N("dd",{},a));s("mass",`${zt(i.mass,"kg")} (${Rn(i.mass/e.mass_initial-1)})`),typeof i.objective=="number"&&s(e.objective?.quantity??"objective",zt(i.objective,e.objective?.unit));let r=(o,a)=>So(a,yr(e.constraints?.[o]));s("worst limit",r(i.worst_limit,i.worst_constraint)+(i.worst_limit?` '${i.worst_limit}'${Og(i.worst_at,t)}`:""));for(let[o,a]of Object.entries(i.limits??{}))o!==i.worst_limit&&s(`limit '${o}'`,r(o,a.violation)+Og(a.at,t));return i.load_change!==void 0&&!e.load_cases&&s("change of the loads",i.load_change===null?"\u2013":Rn(i.load_change).replace("+","")),s("load cases kept",i.load_cases||"\u2013"),s("iterations of the optimiser",i.optimizer_iterations||"\u2013"),n}function B1(i,t){let e=Object.keys(i.design??{});if(!t.some(s=>s.design?.length===e.length)||e.length>60)return null;let n=e.map(s=>{let r=N("i",{}),o=N("span",{});return{name:s,fill:r,value:o,node:N("div",{class:"bar"},N("span",{},s),N("span",{class:"track"},r),o)}});return{node:N("div",{class:"bars"},n.map(s=>s.node)),show(s){if(s?.length===e.length)for(let[r,o]of n.entries()){let a=i.design_range[o.name];o.fill.style.width=`${100*(s[r]-a.lower)/(a.upper-a.lower||1)}%`,o.value.textContent=zt(s[r],a.unit)}}}}function z1(i,t,e,n){let s=t?.view;if(!s||!i.sized.length||!e)return;let r=Object.keys(i.summary.design),o=new Map(r.map((a,l)=>[a,e[l]]));for(let{view:a,body:l}of s.parts){let c=i.sized.filter(u=>u.body===l.name);if(!c.length||!a.setSections)continue;let h=new Map;for(let u of c){let f=h.get(u.element)??l.dimensions.slice(4*u.element,4*u.element+4);for(let p of u.dimensions.split("+")){let g=(F1[l.shapes[u.element]]??[]).indexOf(p);g>=0&&o.get(u.variable)>0&&(f[g]=o.get(u.variable))}h.set(u.element,f)}a.setSections(n?null:h)}s.set({})}function V1(i){let t=i.steps.map(a=>({step:a.step,lines:a.lines.map(l=>qe(l))})),e=H1(t.flatMap(a=>a.lines)),n=bo("path",{class:"material","fill-rule":"evenodd"}),s=bo("path",{class:"before",d:Fg(t[0].lines)}),r=.03*Math.max(e.w,e.h);return{node:N("figure",{class:"outline","data-part":i.part},bo("svg",{viewBox:`${e.x-r} ${-e.y-e.h-r} ${e.w+2*r} ${e.h+2*r}`,role:"img"},bo("title",{},`outline of ${i.part}`),n,s),N("figcaption",{},`${i.part}: outline, that of the start dashed`)),show(a){let l=t[0];for(let c of t)Math.abs(c.step-a)<Math.abs(l.step-a)&&(l=c);n.setAttribute("d",Fg(l.lines))}}}function Fg(i){return i.map(t=>{let e="";for(let n=0;n<t.length;n+=2)e+=`${n?"L":"M"}${t[n].toPrecision(6)} ${(-t[n+1]).toPrecision(6)}`;return e+"Z"}).join("")}function H1(i){let t=1/0,e=1/0,n=-1/0,s=-1/0;for(let r of i)for(let o=0;o<r.length;o+=2)t=Math.min(t,r[o]),n=Math.max(n,r[o]),e=Math.min(e,r[o+1]),s=Math.max(s,r[o+1]);return{x:t,y:e,w:n-t||1,h:s-e||1}}var ta=66,Gl=42,Wl=12,vf=14,Ts=420,ea=12,Bg=2;function Vg(i){return i.map?new Mf(i).card():null}var Mf=class{constructor(t){let e=t.summary,n=t.map.columns;this.names=Object.keys(e.over),this.units=this.names.map(r=>e.over[r].unit),this.of=e.of,this.column=r=>n.find(o=>o.name===r);let s=this.names.map(r=>this.column(r).cells);this.nx=e.over[this.names[0]].points,this.x=s[0].slice(0,this.nx),this.y=s[1].filter((r,o)=>o%this.nx===0),this.reasons=this.column("reason")?.cells??[],this.path=t.path?t.path.columns[1].cells.map((r,o)=>[r,t.path.columns[2].cells[o]]):[],this.centre=this.names.map(r=>e.centre[r])}card(){let t=Object.keys(this.of);this.choice=N("select",{id:"map-of",onchange:()=>this.draw()},t.map(n=>N("option",{value:n},n))),this.local=N("input",{type:"checkbox",id:"map-local",checked:!0,onchange:()=>this.draw()}),this.canvas=N("canvas",{class:"scatter map",tabindex:0,role:"img","aria-label":"contours over two variables; arrows move a pointer that tells the values"}),this.tip=N("div",{class:"tip",hidden:!0,"aria-live":"polite"}),this.plot=N("div",{class:"plot mapbox"},this.canvas,this.tip),this.key=N("span",{class:"colours inline"}),this.legend=N("div",{class:"legend"}),this.canvas.addEventListener("mousemove",n=>this.hover(n));for(let n of["mouseleave","blur"])this.canvas.addEventListener(n,()=>this.hover(null));this.canvas.addEventListener("keydown",n=>this.byKey(n)),new ResizeObserver(()=>this.draw()).observe(this.plot),ds(()=>this.draw());let e=t.some(n=>this.column(`${n} local`));return Xe("Map",N("div",{class:"controls row"},N("label",{for:"map-of"},"quantity"),this.choice,e?N("span",{class:"named"},this.local," ",N("label",{for:"map-local"},"local model")):null,this.key),this.legend,this.plot,N("p",{class:"note"},"Colours: the study itself, simulated at each point of the grid, linear between them."+(e?" Dashed: the problem from which a cycle would take its next design, made at the star.":"")))}values(t){return this.column(t)?.cells??null}draw(){let{canvas:t,plot:e}=this,n=e.clientWidth;if(!n)return;let s=devicePixelRatio||1,r=this.choice.value;Object.assign(t,{width:n*s,height:Ts*s}),t.style.width=`${n}px`,t.style.height=`${Ts}px`;let o=t.getContext("2d");o.scale(s,s),o.font="11px system-ui, sans-serif",this.ax=zg(this.x,ta,n-vf),this.ay=zg(this.y,Ts-Gl,Wl);let a=this.values(r),l=a.filter(g=>g!==null),c=Math.min(...l),h=Math.max(...l),{unit:u,limit:f}=this.of[r];this.levels=l.length&&h>c?[...Array(ea-1)].map((g,x)=>c+(x+1)*(h-c)/ea):[],this.fill(o,a,c,h);for(let g of this.levels)this.contour(o,a,g,dn("ink"),.5,[]);let p=this.local.checked?this.values(`${r} local`):null;if(p)for(let g of this.levels)this.contour(o,p,g,Pn[1],1.1,[5,4]);f!==null&&(this.contour(o,a,f,dn("bad"),2.6,[]),p&&this.contour(o,p,f,dn("bad"),2.2,[6,4])),this.drawAxes(o,n),this.drawDesigns(o),this.describe(c,h,u,f,!!p)}fill(t,e,n,s){let r=this.ax.at(this.x[0]),o=this.ax.at(this.x[this.nx-1]),a=this.ay.at(this.y[0]),l=this.ay.at(this.y[this.y.length-1]),c=Math.max(1,Math.round((o-r)/Bg)),h=Math.max(1,Math.round((a-l)/Bg)),u=N("canvas",{width:c,height:h}),f=new ImageData(c,h),p=[0,0,0];for(let g=0;g<h;++g)for(let x=0;x<c;++x){let m=this.valueAt(e,this.ax.from(r+(x+.5)/c*(o-r)),this.ay.from(l+(g+.5)/h*(a-l)));if(m===null)continue;let d=s>n?Math.min(ea-1,Math.floor(ea*(m-n)/(s-n))):0,M=4*(g*c+x);vr("size",(d+.5)/ea,p,0);for(let b=0;b<3;++b)f.data[M+b]=255*p[b];f.data[M+3]=255}u.getContext("2d").putImageData(f,0,0),t.imageSmoothingEnabled=!1,t.drawImage(u,r,l,o-r,a-l)}valueAt(t,e,n){let{nx:s}=this,[r,o]=Xl(this.x,e),[a,l]=Xl(this.y,n),[c,h,u,f]=[t[a*s+r],t[a*s+r+1],t[(a+1)*s+r],t[(a+1)*s+r+1]];return[c,h,u,f].some(p=>p==null)?null:(1-l)*((1-o)*c+o*h)+l*((1-o)*u+o*f)}contour(t,e,n,s,r,o){let{nx:a,x:l,y:c,ax:h,ay:u}=this;t.beginPath();for(let f=0;f+1<c.length;++f)for(let p=0;p+1<a;++p){let g=[[p,f],[p+1,f],[p+1,f+1],[p,f+1]],x=g.map(([d,M])=>e[M*a+d]);if(x.some(d=>d===null))continue;let m=[];for(let d=0;d<4;++d){let M=x[d],b=x[(d+1)%4];if(M<n==b<n)continue;let y=(n-M)/(b-M),[U,C]=g[d],[D,O]=g[(d+1)%4];m.push([h.at(l[U]+y*(l[D]-l[U])),u.at(c[C]+y*(c[O]-c[C]))])}for(let d=0;d+1<m.length;d+=2)t.moveTo(...m[d]),t.lineTo(...m[d+1])}t.strokeStyle=s,t.lineWidth=r,t.setLineDash(o),t.stroke(),t.setLineDash([]),t.lineWidth=1}drawAxes(t,e){let{ax:n,ay:s}=this,r=l=>{let c=Fi(Math.max(...(l?this.y:this.x).map(Math.abs)),this.units[l]);return{scale:c,text:`${this.names[l]}${c.unit&&c.unit!=="-"?` [${c.unit}]`:""}`}},o=r(0),a=r(1);t.fillStyle=dn("soft"),t.strokeStyle=dn("line"),t.strokeRect(ta,Wl,e-vf-ta,Ts-Gl-Wl),t.textAlign="center";for(let l of n.ticks)t.fillText(Fn(l/o.scale.factor,3),n.at(l),Ts-Gl+15);t.fillText(o.text,(ta+e-vf)/2,Ts-6),t.textAlign="right";for(let l of s.ticks)t.fillText(Fn(l/a.scale.factor,3),ta-7,s.at(l)+4);t.save(),t.translate(12,(Ts-Gl+Wl)/2),t.rotate(-Math.PI/2),t.textAlign="center",t.fillText(a.text,0,0),t.restore()}drawDesigns(t){let{ax:e,ay:n}=this;t.strokeStyle=t.fillStyle="#fff";let s=this.path.map(([a,l])=>[e.at(a),n.at(l)]);for(let[a,l]of[[4,"rgb(0 0 0 / .55)"],[1.8,"#fff"]]){t.beginPath();for(let c of s)t.lineTo(...c);t.lineWidth=a,t.strokeStyle=l,t.stroke()}t.lineWidth=1,t.strokeStyle="#000";for(let[a,l]of s)t.beginPath(),t.arc(a,l,3.6,0,2*Math.PI),t.fillStyle="#fff",t.fill(),t.stroke();let[r,o]=[e.at(this.centre[0]),n.at(this.centre[1])];t.beginPath();for(let a=0;a<10;++a)t.lineTo(r+(a%2?3.5:9)*Math.sin(a*Math.PI/5),o-(a%2?3.5:9)*Math.cos(a*Math.PI/5));t.closePath(),t.fillStyle=Pn[1],t.fill(),t.stroke()}describe(t,e,n,s,r){let o=N("span",{class:"strip viridis"});this.key.replaceChildren(N("span",{},Number.isFinite(t)?zt(t,n,3):"no value"," ",o," ",Number.isFinite(e)?zt(e,n,3):""));let a=(l,c,h)=>N("span",{},Lr(l,c),h);this.legend.replaceChildren(...[s!==null?a("var(--bad)",!1,`limit ${zt(s,n)}`):null,r?a(Pn[1],!0,"local model"):null,this.path.length?N("span",{},"\u25CB designs of the optimisation"):null,N("span",{},"\u2605 centre")].filter(Boolean))}byKey(t){let e={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[t.key];!e||!this.ax||t.ctrlKey||t.metaKey||t.altKey||(this.pointed=[this.x,this.y].map((n,s)=>{let r=n[0],o=n[n.length-1]-r,a=(this.pointed??this.centre)[s];return r+o*Math.max(1e-6,Math.min(1-1e-6,(a-r)/o+e[s]/40))}),this.hover({offsetX:this.ax.at(this.pointed[0]),offsetY:this.ay.at(this.pointed[1])}),t.preventDefault(),t.stopPropagation())}hover(t){let{ax:e,ay:n,names:s,units:r,tip:o}=this;if(t||(o.hidden=!0),!e||!t)return;let a=e.from(t.offsetX),l=n.from(t.offsetY),c=a>=this.x[0]&&a<=this.x[this.nx-1]&&l>=this.y[0]&&l<=this.y[this.y.length-1];if(o.hidden=!c,!c)return;let h=[`${s[0]} ${zt(a,r[0])}, ${s[1]} ${zt(l,r[1])}`];for(let[d,{unit:M,limit:b}]of Object.entries(this.of)){let y=this.valueAt(this.values(d),a,l),U=this.values(`${d} local`),C=U?this.valueAt(U,a,l):null;h.push(`${d}: ${y===null?"\u2013":zt(y,M)}${y!==null&&b?`, ${Rn(y/b-1)} above the limit`:""}`+(C===null?"":`; local ${zt(C,M)}`))}let[u,f]=Xl(this.x,a),[p,g]=Xl(this.y,l),x=this.reasons[(p+Math.round(g))*this.nx+u+Math.round(f)];x&&h.push(x),o.replaceChildren(...h.map((d,M)=>N(M?"div":"b",{},d)));let m=t.offsetX>this.plot.clientWidth/2;o.style.left=m?"auto":`${t.offsetX+14}px`,o.style.right=m?`${this.plot.clientWidth-t.offsetX+14}px`:"auto",o.style.top=`${Math.min(t.offsetY,Ts-130)}px`}};function Xl(i,t){let e=0;for(;e+2<i.length&&i[e+1]<=t;)++e;return[e,Math.max(0,Math.min(1,(t-i[e])/(i[e+1]-i[e])))]}function zg(i,t,e){let n=i[0],s=i[i.length-1],r=s-n||1;return{ticks:dh(n,s),at:o=>t+(o-n)/r*(e-t),from:o=>n+(o-t)/(e-t)*r}}var G1=.13,W1=new L(0,1,0),bf=new L,Cs=new L,Sf=new L,ql={x:new L(1,0,0),y:new L(0,1,0),z:new L(0,0,1)},X1={x:"x",y:"y",z:"z",r:"turn"},Yl=class extends Qo{constructor(t,e){super(t),this.summary=e,this.solid=t.parts.find(r=>r.view.sizes)?.view,this.loads=e.fixed_loads.map(r=>({...r,size:Math.hypot(...r.force),at:r.points.flat()})),this.unit=G1*t.size/Math.max(1e-300,...this.loads.map(r=>r.size)),this.marks=[];let n=new Jn,s=Qn(7042176);for(let r of e.supports)this.addMarks(r,n,s);t.scene.add(n);for(let r=0;r<t.t.length;++r){Object.assign(t,{instant:r}).update();for(let o of[n,this.mesh])t.box.union(new Ei().setFromObject(o))}t.fit()}addMarks({held:t,points:e},n,s){let r=.011*this.view.size,o=e.flat(),a=[...t].filter(c=>ql[c]),l=this.isWhole(t);for(let c=0;c<e.length;++c)for(let h of l?["x"]:a){let u=ql[h].clone().multiplyScalar(this.outward(e[c],ql[h])),f=new Le(l?new jn(1.7*r,1.7*r,1.7*r):new Vi(r,2*r,4),s);n.add(f),this.marks.push({mesh:f,at:o,k:c,out:u,height:l?0:r})}}isWhole(t){return[...t].filter(e=>ql[e]).length===(this.solid.planar?2:3)}outward(t,e){let{x0:n,vertices:s}=this.solid;return this.middle??(this.middle=new L(...n.map(r=>r.reduce((o,a)=>o+a,0)/s))),bf.set(...t).sub(this.middle).dot(e)<0?-1:1}shown(){let{load_cases:t}=this.summary,e=t[Math.round(this.view.instant)];return this.loads.filter(n=>t.length<2||n.load_case===e)}update(){let{solid:t,marks:e}=this,n=t.mesh.quaternion;for(let{mesh:r,at:o,k:a,out:l,height:c}of e)t.place(o,3*a,bf),Cs.copy(l).applyQuaternion(n),r.position.copy(bf).addScaledVector(Cs,c),r.quaternion.setFromUnitVectors(W1,Cs.negate());let s=0;for(let r of this.shown()){let o=r.size*this.unit*this.view.phase;if(!(o<.001*this.view.size))for(let a=0;3*a<r.at.length;++a){Cs.set(...r.force).normalize();let l=this.outward(r.points[a],Cs)<0;Cs.applyQuaternion(n),t.place(r.at,3*a,Sf),l&&Sf.addScaledVector(Cs,-o),this.put(s++,Sf,Cs,o)}}this.end(s)}legend(){let t=this.summary.supports.map(({place:n,held:s})=>n==="inertia_relief"?N("span",{},"held nowhere: its inertia balances the loads"):N("span",{},N("i",{class:"held"},this.isWhole(s)?"\u25A0":"\u25B2"),` held: ${n} (${[...s].map(r=>X1[r]??r).join(", ")})`)),e=({name:n,place:s,moment:r,size:o})=>{let a=Math.hypot(...r),l=[o>0?zt(o,"N",3):"",a>0?zt(a,"N m",3):""].filter(Boolean).join(" and ");return`${n}: ${l} on ${s}`};return[...t,...this.shown().map(n=>N("span",{},N("i",{class:"force"},"\u2192"),` ${e(n)}`))]}};var Hg={type:"change"},Ef={type:"start"},Wg={type:"end"},$l=new ro,Gg=new Mi,q1=Math.cos(70*Sg.DEG2RAD),on=new L,zn=2*Math.PI,Ae={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},wf=1e-6,Zl=class extends Fl{constructor(t,e=null){super(t,e),this.state=Ae.NONE,this.enabled=!0,this.target=new L,this.cursor=new L,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:rr.ROTATE,MIDDLE:rr.DOLLY,RIGHT:rr.PAN},this.touches={ONE:or.ROTATE,TWO:or.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new L,this._lastQuaternion=new Pe,this._lastTargetPosition=new L,this._quat=new Pe().setFromUnitVectors(t.up,new L(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Jo,this._sphericalDelta=new Jo,this._scale=1,this._panOffset=new L,this._rotateStart=new Qt,this._rotateEnd=new Qt,this._rotateDelta=new Qt,this._panStart=new Qt,this._panEnd=new Qt,this._panDelta=new Qt,this._dollyStart=new Qt,this._dollyEnd=new Qt,this._dollyDelta=new Qt,this._dollyDirection=new L,this._mouse=new Qt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=$1.bind(this),this._onPointerDown=Y1.bind(this),this._onPointerUp=Z1.bind(this),this._onContextMenu=nE.bind(this),this._onMouseWheel=j1.bind(this),this._onKeyDown=Q1.bind(this),this._onTouchStart=tE.bind(this),this._onTouchMove=eE.bind(this),this._onMouseDown=K1.bind(this),this._onMouseMove=J1.bind(this),this._interceptControlDown=iE.bind(this),this._interceptControlUp=sE.bind(this),this.domElement!==null&&this.connect(),this.update()}connect(){this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Hg),this.update(),this.state=Ae.NONE}update(t=null){let e=this.object.position;on.copy(e).sub(this.target),on.applyQuaternion(this._quat),this._spherical.setFromVector3(on),this.autoRotate&&this.state===Ae.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=zn:n>Math.PI&&(n-=zn),s<-Math.PI?s+=zn:s>Math.PI&&(s-=zn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(on.setFromSpherical(this._spherical),on.applyQuaternion(this._quatInverse),e.copy(this.target).add(on),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=on.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new L(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new L(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=on.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):($l.origin.copy(this.object.position),$l.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot($l.direction))<q1?this.object.lookAt(this.target):(Gg.setFromNormalAndCoplanarPoint(this.object.up,this.target),$l.intersectPlane(Gg,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>wf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>wf||this._lastTargetPosition.distanceToSquared(this.target)>wf?(this.dispatchEvent(Hg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?zn/60*this.autoRotateSpeed*t:zn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){on.setFromMatrixColumn(e,0),on.multiplyScalar(-t),this._panOffset.add(on)}_panUp(t,e){this.screenSpacePanning===!0?on.setFromMatrixColumn(e,1):(on.setFromMatrixColumn(e,0),on.crossVectors(this.object.up,on)),on.multiplyScalar(t),this._panOffset.add(on)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;on.copy(s).sub(this.target);let r=on.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(zn*this._rotateDelta.x/e.clientHeight),this._rotateUp(zn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateUp(zn*this.rotateSpeed/this.domElement.clientHeight):this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateUp(-zn*this.rotateSpeed/this.domElement.clientHeight):this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateLeft(zn*this.rotateSpeed/this.domElement.clientHeight):this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this._rotateLeft(-zn*this.rotateSpeed/this.domElement.clientHeight):this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(zn*this._rotateDelta.x/e.clientHeight),this._rotateUp(zn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Qt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function Y1(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function $1(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function Z1(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Wg),this.state=Ae.NONE;break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function K1(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case rr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ae.DOLLY;break;case rr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ae.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ae.ROTATE}break;case rr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ae.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ae.PAN}break;default:this.state=Ae.NONE}this.state!==Ae.NONE&&this.dispatchEvent(Ef)}function J1(i){switch(this.state){case Ae.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ae.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ae.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function j1(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ae.NONE||(i.preventDefault(),this.dispatchEvent(Ef),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Wg))}function Q1(i){this.enabled===!1||this.enablePan===!1||this._handleKeyDown(i)}function tE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case or.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Ae.TOUCH_ROTATE;break;case or.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Ae.TOUCH_PAN;break;default:this.state=Ae.NONE}break;case 2:switch(this.touches.TWO){case or.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ae.TOUCH_DOLLY_PAN;break;case or.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ae.TOUCH_DOLLY_ROTATE;break;default:this.state=Ae.NONE}break;default:this.state=Ae.NONE}this.state!==Ae.NONE&&this.dispatchEvent(Ef)}function eE(i){switch(this._trackPointer(i),this.state){case Ae.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ae.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ae.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ae.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ae.NONE}}function nE(i){this.enabled!==!1&&i.preventDefault()}function iE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function sE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Jl=class{constructor(t,e){let n=e*t.nodes;Object.assign(this,{name:t.name,kind:t.kind,nodes:t.nodes,instants:e,elements:[]});for(let s=0;s<t.elements.length;s+=2)this.elements.push([t.elements[s],t.elements[s+1]]);this.shapes=t.shapes,this.dimensions=t.dimensions,this.points=t.points,this.xs=li(t.x,n),this.qs=li(t.q,n),this.x0=qe(t.x0),this.q0=qe(t.q0),this.force=t.force?li(t.force,n):null,this.stress=t.stress?qe(t.stress):null,this.x=new Float32Array(3*t.nodes),this.q=new Float32Array(4*t.nodes)}at(t,e){let n=this.nodes,s=t*n,r=Math.min(t+1,this.instants-1)*n;for(let o=0;o<n;++o){for(let a=0;a<3;++a)this.x[3*o+a]=(1-e)*this.xs[a][s+o]+e*this.xs[a][r+o];for(let a=0;a<4;++a)this.q[4*o+a]=(1-e)*this.qs[a][s+o]+e*this.qs[a][r+o];Xg(this.q,4*o)}}enlarge(t){let{x:e,q:n,x0:s,q0:r}=this;if(t!==1){for(let o=0;o<e.length;++o)e[o]=s[o]+t*(e[o]-s[o]);for(let o=0;o<n.length;o+=4){let a=0;for(let l=o;l<o+4;++l)a+=r[l]*n[l];for(let l=o;l<o+4;++l)n[l]=r[l]+t*(Math.sign(a||1)*n[l]-r[l]);Xg(n,o)}}}values(t,e,n,s){let r=s.length,o=e*r,a=Math.min(e+1,this.instants-1)*r;for(let l=0;l<r;++l)s[l]=(1-n)*t[o+l]+n*t[a+l]}};function Xg(i,t){let e=Math.hypot(i[t],i[t+1],i[t+2],i[t+3])||1;for(let n=0;n<4;++n)i[t+n]/=e}var Hi=new Pe,qg=new Pe,jl=class{constructor(t){this.body=t,this.turn=new Pe,this.d=new Float32Array(3*t.nodes),this.e=new Float32Array(3*t.nodes),this.v=new L,this.along=new Float32Array(t.nodes);for(let e=1;e<t.nodes;++e)this.along[e]=this.along[e-1]+oE(t.x0,e-1,e);this.between(0,t.nodes-1)}between(t,e){let{along:n}=this;this.anchors=[t,e],this.length=n[e]-n[t],this.share=n.map(s=>(s-n[t])/(this.length||1))}update(){let{body:t,anchors:e,turn:n,v:s}=this;aE(t,n);for(let r=0;r<t.nodes;++r){let o=this.share[r];s.set(...[0,1,2].map(a=>t.x0[3*r+a]-Kl(t.x0,a,e,o))).applyQuaternion(n),this.d[3*r]=t.x[3*r]-Kl(t.x,0,e,o)-s.x,this.d[3*r+1]=t.x[3*r+1]-Kl(t.x,1,e,o)-s.y,this.d[3*r+2]=t.x[3*r+2]-Kl(t.x,2,e,o)-s.z}}shift(t,e,n){let{anchors:s,e:r,share:o,v:a}=this,l=[...new Set([...s,...n.map(c=>c.node)])].sort((c,h)=>c-h);for(let c=0;c<o.length;++c){a.copy(t).lerp(e,o[c]);for(let{node:h,by:u}of n)a.addScaledVector(u,rE(o,l,h,c));a.toArray(r,3*c)}}place(t,e,n){let{d:s,e:r}=this,o=this.body.x,a=e-1,l=3*t;return n.set(o[l]+a*s[l]+r[l],o[l+1]+a*s[l+1]+r[l+1],o[l+2]+a*s[l+2]+r[l+2])}tangent(t,e,n,s,r,o){let{body:a,anchors:[l,c],turn:h,v:u,e:f}=this,p=r-1,g=s/(this.length||1);return Yg(a.q,n,o).multiplyScalar(s),Yg(a.q0,n,u).multiplyScalar(s),u.x-=g*(a.x0[3*c]-a.x0[3*l]),u.y-=g*(a.x0[3*c+1]-a.x0[3*l+1]),u.z-=g*(a.x0[3*c+2]-a.x0[3*l+2]),u.applyQuaternion(h),o.set(o.x+p*(o.x-g*(a.x[3*c]-a.x[3*l])-u.x)+f[3*e]-f[3*t],o.y+p*(o.y-g*(a.x[3*c+1]-a.x[3*l+1])-u.y)+f[3*e+1]-f[3*t+1],o.z+p*(o.z-g*(a.x[3*c+2]-a.x[3*l+2])-u.z)+f[3*e+2]-f[3*t+2])}size(t){return Math.hypot(this.d[3*t],this.d[3*t+1],this.d[3*t+2])}};function rE(i,t,e,n){let s=t.indexOf(e),r=n<e?t[s-1]:t[s+1];return n===e||r===void 0?1:Math.max(0,1-(i[n]-i[e])/(i[r]-i[e]))}function Kl(i,t,[e,n],s){return(1-s)*i[3*e+t]+s*i[3*n+t]}function oE(i,t,e){return Math.hypot(i[3*e]-i[3*t],i[3*e+1]-i[3*t+1],i[3*e+2]-i[3*t+2])}function Yg(i,t,e){let n=i[4*t],s=i[4*t+1],r=i[4*t+2],o=i[4*t+3];return e.set(1-2*(s*s+r*r),2*(n*s+r*o),2*(n*r-s*o))}function aE(i,t){let e=0,n=0,s=0,r=0;for(let o=0;o<i.nodes;++o){Hi.fromArray(i.q,4*o),qg.fromArray(i.q0,4*o).conjugate(),Hi.multiply(qg);let a=e*Hi.x+n*Hi.y+s*Hi.z+r*Hi.w<0?-1:1;e+=a*Hi.x,n+=a*Hi.y,s+=a*Hi.z,r+=a*Hi.w}t.set(e,n,s,r).normalize()}function Zg(i,t,e){switch(i){case"circle":return Tf([Ql(t[0]/2)],20);case"tube":return $g(Ql(t[0]/2),Ql(t[0]/2-t[1],!0),20);case"rectangle":return Tf([Af(t[0],t[1])],4);case"box":return $g(Af(t[0],t[1]),Af(t[0]-2*t[2],t[1]-2*t[2],!0),4);case"I":return lE(t);default:return Tf([Ql(e)],20)}}function Ql(i,t=!1){let e=[];for(let n=0;n<20;++n){let s=2*Math.PI*n/20;e.push([i*Math.cos(s),i*Math.sin(s)])}return{points:e,smooth:!0,inner:t}}function Af(i,t,e=!1){let n=i/2,s=t/2;return{points:[[-n,-s],[n,-s],[n,s],[-n,s]],smooth:!1,inner:e}}function Tf(i,t){let e=[];for(let n=2;n<t;++n)e.push([0,n-1,n]);return{loops:i,caps:e}}function $g(i,t,e){let n=[];for(let s=0;s<e;++s){let r=(s+1)%e;n.push([s,r,e+r],[s,e+r,e+s])}return{loops:[i,t],caps:n}}function lE([i,t,e,n]){let s=i/2,r=t/2,o=r-e,a=n/2,l=[[-s,-r],[s,-r],[s,-o],[a,-o],[a,o],[s,o],[s,r],[-s,r],[-s,o],[-a,o],[-a,-o],[-s,-o]],c=(h,u,f,p)=>[[h,u,f],[h,f,p]];return{loops:[{points:l,smooth:!1,inner:!1}],caps:[...c(0,1,2,11),...c(10,3,4,9),...c(8,5,6,7)]}}function Kg(i){return Math.max(...i.loops[0].points.map(([t,e])=>Math.hypot(t,e)))}var cE=400,ec=class{constructor(t,e){this.body=t,this.chord=new jl(t),this.fallback=.006*e,this.parts=Math.max(1,Math.min(6,Math.floor(cE/t.elements.length/2))),this.mesh=new Le(new nn,Qn()),this.mesh.frustumCulled=!1,this.value=new Float32Array(t.nodes),this.ends=new Float32Array(2*t.elements.length),this.setSections(null)}setSections(t){let{body:e}=this;this.sections=e.elements.map((n,s)=>{let r=e.dimensions.slice(4*s,4*s+4);return Zg(e.shapes[s],t?.get(s)??r,this.fallback)}),this.build()}radiusAt(t){let e=this.body.elements.flatMap((n,s)=>n.includes(t)?[Kg(this.sections[s])]:[]);return e.length?Math.max(...e):0}get anchors(){return this.chord.anchors}share(t){return this.chord.share[t]}bend(t,e){return e.fromArray(this.chord.d,3*t)}shift(t,e,n){this.chord.shift(t,e,n)}build(){let t=[],e=[];this.stations=[];for(let[s,r]of this.sections.entries()){let o=this.stations.length;for(let a=0;a<=this.parts;++a){this.stations.push({e:s,xi:a/this.parts,first:t.length});for(let l of r.loops)uE(l,t);this.stations[this.stations.length-1].end=t.length}for(let a=0;a<this.parts;++a)fE(this.stations[o+a].first,this.stations[o+a+1].first,r,e);jg(r,s,0,-1,t,e,this.stations),jg(r,s,1,1,t,e,this.stations)}let n=new nn;this.rows=Float32Array.from(t.flat());for(let s of["position","normal","color"])n.setAttribute(s,new Ke(new Float32Array(3*t.length),3));n.setIndex(e),this.mesh.geometry.dispose(),this.mesh.geometry=n}spread(){for(let[t,[e,n]]of this.body.elements.entries())this.ends[2*t]=this.value[e],this.ends[2*t+1]=this.value[n]}update(t,e,n){let{mesh:s,rows:r}=this,o=s.geometry.attributes.position.array,a=s.geometry.attributes.normal.array,l=s.geometry.attributes.color.array;for(let c of this.stations){this.frame(c,t);let h=(1-c.xi)*this.ends[2*c.e]+c.xi*this.ends[2*c.e+1];for(let u=c.first;u<c.end;++u){let f=r[5*u],p=r[5*u+1],g=r[5*u+2],x=r[5*u+3],m=r[5*u+4],d=3*u;o[d]=tc.x+f*Gi.x+p*ar.x,o[d+1]=tc.y+f*Gi.y+p*ar.y,o[d+2]=tc.z+f*Gi.z+p*ar.z,a[d]=g*Gi.x+x*ar.x+m*Rs.x,a[d+1]=g*Gi.y+x*ar.y+m*Rs.y,a[d+2]=g*Gi.z+x*ar.z+m*Rs.z,e?vr(e.map,(h-e.low)/(e.high-e.low||1),l,d):n.toArray(l,d)}}for(let c of["position","normal","color"])s.geometry.attributes[c].needsUpdate=!0}frame({e:t,xi:e},n){let{body:s,chord:r}=this,[o,a]=s.elements[t],l=Math.hypot(...[0,1,2].map(f=>s.x0[3*a+f]-s.x0[3*o+f]));r.place(o,n,Qg),r.place(a,n,t0),r.tangent(o,a,o,l,n,e0),r.tangent(o,a,a,l,n,n0);let c=e,h=c*c,u=h*c;Jg(tc,2*u-3*h+1,u-2*h+c,3*h-2*u,u-h),Jg(Rs,6*h-6*c,3*h-4*c+1,6*c-6*h,3*h-2*c),Rs.normalize(),hE(s.q,o,a,c,Gi),Gi.addScaledVector(Rs,-Gi.dot(Rs)).normalize(),ar.crossVectors(Rs,Gi)}},Qg=new L,t0=new L,e0=new L,n0=new L,tc=new L,Rs=new L,Gi=new L,ar=new L;function Jg(i,t,e,n,s){i.set(0,0,0).addScaledVector(Qg,t).addScaledVector(e0,e).addScaledVector(t0,n).addScaledVector(n0,s)}function hE(i,t,e,n,s){let r=0;for(let f=0;f<4;++f)r+=i[4*t+f]*i[4*e+f];let o=r<0?-n:n,a=1-n,l=a*i[4*t]+o*i[4*e],c=a*i[4*t+1]+o*i[4*e+1],h=a*i[4*t+2]+o*i[4*e+2],u=a*i[4*t+3]+o*i[4*e+3];return s.set(2*(l*c-h*u),u*u-l*l+c*c-h*h,2*(c*h+l*u))}function uE(i,t){let e=i.points.length,n=i.inner?-1:1;for(let s=0;s<e;++s){let[r,o]=i.points[s];if(i.smooth){let f=Math.hypot(r,o)||1;t.push([r,o,n*r/f,n*o/f,0]);continue}let[a,l]=i.points[(s+1)%e],c=Math.hypot(a-r,l-o)||1,h=n*(l-o)/c,u=n*(r-a)/c;t.push([r,o,h,u,0],[a,l,h,u,0])}}function fE(i,t,e,n){let s=0;for(let r of e.loops){let o=r.points.length;for(let a=0;a<o;++a){let l=r.smooth?s+a:s+2*a,c=r.smooth?s+(a+1)%o:s+2*a+1;n.push(i+l,i+c,t+c,i+l,t+c,t+l)}s+=r.smooth?o:2*o}}function jg(i,t,e,n,s,r,o){let a=s.length;for(let l of i.loops)for(let[c,h]of l.points)s.push([c,h,0,0,n]);for(let[l,c,h]of i.caps)n>0?r.push(a+l,a+c,a+h):r.push(a+l,a+h,a+c);o.push({e:t,xi:e,first:a,end:s.length})}var ia=new L(0,1,0),na=new L,fo=new L,i0=new Pe,ic=class{constructor(t,e,n){this.body=t,this.material=Qn(9081500),this.mesh=new Jn;let s=new L(...t.points.slice(0,3)),r=.013*n,o=new Le(new jn(2*r,2*r,2*r),this.material);o.position.copy(s),this.mesh.add(o);let a=[new L,...e];for(let l=3;l<t.points.length;l+=3)a.push(new L(...t.points.slice(l,l+3)));for(let l of a)l.distanceTo(s)>1.5*r&&this.mesh.add(dE(s,l,.3*r,this.material))}update(){this.mesh.position.fromArray(this.body.x,0),this.follows&&this.mesh.position.add(this.follows),this.mesh.quaternion.fromArray(this.body.q,0)}};function dE(i,t,e,n){let s=new L().subVectors(t,i),r=new Le(new Bn(e,e,s.length(),10),n);return r.position.copy(i).addScaledVector(s,.5),r.quaternion.setFromUnitVectors(ia,s.normalize()),r}var s0={revolute:i=>new Bn(i,i,2.6*i,20),cylindrical:i=>new Bn(.7*i,.7*i,4.5*i,20),screw:i=>new Bn(.7*i,.7*i,4.5*i,6),prismatic:i=>new jn(1.5*i,4*i,1.5*i),planar:i=>new Bn(2*i,2*i,.4*i,20),spherical:i=>new nr(1.2*i,20,12),universal:i=>new nr(1.1*i,8,6),fixed:i=>new jn(1.7*i,1.7*i,1.7*i)},Cf=["rod","cylinder"],nc=new L,sc=class{constructor(t,e,n){this.joint=t,this.mesh=new Jn;let s=Qn(14254635);Cf.includes(t.type)&&(this.link=new Le(new Bn(.45*e,.45*e,1,12),Qn(9081500)),this.mesh.add(this.link));let r=(s0[t.type]??s0.spherical)(e);if(this.glyph=new Le(r,s),this.axis=new L(...t.axis.length?t.axis:[0,0,1]),this.mesh.add(this.glyph),this.grounded=t.bodies.indexOf("ground"),this.grounded>=0){this.foot=new Le(new Vi(2.2*e,2.6*e,4),Qn(7042176));let o=t.type==="prismatic"?2.2*e:1.3*e;this.foot.quaternion.setFromUnitVectors(ia,n),this.offset=n.clone().multiplyScalar(-o-.4*e),this.mesh.add(this.foot)}}update(t){let{joint:e}=this,n=e.bodies[1]==="ground"?0:1;t.place(e.bodies[n],e.nodes[n],e.places,3*n,na),t.turn(e.bodies[1],e.nodes[1],i0),fo.copy(this.axis).applyQuaternion(i0),this.glyph.position.copy(na),this.glyph.quaternion.setFromUnitVectors(ia,fo),this.link&&(t.place(e.bodies[1-n],e.nodes[1-n],e.places,3*(1-n),fo),nc.subVectors(fo,na),this.link.position.copy(na).addScaledVector(nc,.5),this.link.scale.y=nc.length()||1e-9,this.link.quaternion.setFromUnitVectors(ia,nc.normalize())),this.foot&&(t.place("ground",0,e.places,3*this.grounded,fo),this.foot.position.copy(e.type==="prismatic"||this.link?fo:na).add(this.offset))}};function r0(i,t,e,n){let s=i.getSize(new L).length(),r=s/12,o=10**Math.floor(Math.log10(r)),a=[1,2,5,10].map(p=>p*o).find(p=>p>=r),l=12,c=[];for(let p=-l;p<=l;++p)c.push(-l,0,p,l,0,p,p,0,-l,p,0,l);let h=new nn;h.setAttribute("position",new Ke(Float32Array.from(c,p=>p*a),3));let u=new Nl(h,Lg(n,.55));u.quaternion.setFromUnitVectors(ia,t);let f=i.getCenter(new L).divideScalar(a).round().multiplyScalar(a);return u.position.copy(f).addScaledVector(t,e-f.dot(t)),{helper:u,step:a}}var pE=4,Pf=new L,o0=new L,a0=new L,If=class{constructor(){this.shift=new L,this.held=!1,this.between=[]}},Lf=class{constructor(t,e){let n=[...e.keys()].sort((o,a)=>o-a),s=n.filter(o=>e.get(o).joined);t.chord&&s.length>1&&t.chord.between(s[0],s[s.length-1]),this.view=t,this.single=s.length===1?s[0]:null;let r=this.single===null?t.anchors:[this.single];this.ends=r.map(o=>e.get(o)?.point??null),this.inner=n.filter(o=>!r.includes(o)).map(o=>({node:o,point:e.get(o).point}));for(let{node:o,point:a}of this.inner)a.between.push({carried:this,node:o})}base(t,e,n){let{ends:[s,r],single:o,view:a}=this;if(o!==null){n.copy(e.copy(s.shift).addScaledVector(a.bend(o,l0),-t));return}e.copy((s??r)?.shift??Pf),n.copy((r??s)?.shift??Pf)}away(t,e,n){return this.base(e,n,c0),n.lerp(c0,this.view.share(t)).addScaledVector(this.view.bend(t,l0),e)}apply(t){let e=[];for(let{node:n,point:s}of this.inner){let r=new L().copy(s.shift).sub(this.away(n,t,Df));r.lengthSq()>1e-12*Df.lengthSq()&&e.push({node:n,by:r})}this.base(t,o0,a0),this.view.shift(o0,a0,e)}},l0=new L,c0=new L,Df=new L,rc=class{constructor(t,e){this.views=new Map(t.map(({view:n,body:s})=>[s.name,n])),this.places=new Map;for(let n of e)this.join(n);this.bodies=[];for(let[n,s]of this.views){let r=new Map([...this.places.values()].filter(o=>o.body===n).map(o=>[o.node,o]));s.bend?this.bodies.push(new Lf(s,r)):s.follows=this.shiftOf(n,0)}this.points=[...new Set([...this.places.values()].map(n=>n.point))].filter(n=>n.between.length&&!n.held)}join(t){var o;let e=Cf.includes(t.type),[n,s]=[0,1].map(a=>this.placeOf(t.bodies[a],t.nodes[a],!e));if(e)return;if(!n||!s){for(let a of[n,s])a&&(a.point.held=!0);return}let{point:r}=n;(o=s.point).held||(o.held=r.held);for(let a of this.places.values())a.point===r&&(a.point=s.point)}keyOf(t,e){return this.views.get(t).bend?`${t}|${e}`:t}placeOf(t,e,n){if(!this.views.has(t))return null;let s=this.keyOf(t,e);this.places.has(s)||this.places.set(s,{body:t,node:e,point:new If,joined:!1});let r=this.places.get(s);return r.joined||(r.joined=n),r}update(t){for(let e of this.points)e.shift.set(0,0,0);for(let e=0;t!==0&&e<pE;++e)for(let{shift:n,between:s}of this.points){Rf.set(0,0,0);for(let{carried:r,node:o}of s)Rf.add(r.away(o,t,Df));n.copy(Rf).divideScalar(s.length)}for(let e of this.bodies)e.apply(t)}shiftOf(t,e){return this.views.has(t)&&this.places.get(this.keyOf(t,e))?.point.shift||Pf}},Rf=new L;var h0=new L,u0=new L,mE=new Pe;function oc(i,t,e){let n=i.displacements??(i.displacements=new Map);return n.has(e)||(n.size>1&&n.delete(n.keys().next().value),n.set(e,i.sizes?_E(i,t,e):gE(t,e))),n.get(e)}function f0(i,t,e,n){let s=oc(i,t,e);if(n===0||e+1>=t.instants)return s;let r=oc(i,t,e+1);return s.map((o,a)=>(1-n)*o+n*r[a])}function gE(i,t){return i.at(t,0),Float32Array.from({length:i.nodes},(e,n)=>h0.fromArray(i.x,3*n).distanceTo(u0.fromArray(i.x0,3*n)))}function _E(i,t,e){let n=(s,r,o,a,l)=>l.set(...[0,1,2].map(c=>i.x0[c][s]+a*i.u[3*s+c])).applyQuaternion(mE.fromArray(o,0)).add(new L().fromArray(r,0));return t.at(e,0),i.at(e,0),i.deform(1),Float32Array.from({length:i.vertices},(s,r)=>n(r,t.x,t.q,1,h0).distanceTo(n(r,t.x0,t.q0,0,u0)))}var xE=[["N","axial force","N",[0],"signed"],["V","shear force","N",[1,2],"size"],["M","bending moment","N m",[4,5],"size"],["T","torque","N m",[3],"signed"]];function p0(i,t){let e=d0("stress","stress (von Mises)","Pa","size",s=>s.stress,i);e.high=e.size=Math.max(e.size,t);let n=[e];for(let[s,r,o,a,l]of xE)n.push(d0(s,r,o,l,c=>c.force?yE(c,a):null,i));return n.filter(s=>s.high>s.low&&s.size>1e-9)}function d0(i,t,e,n,s,r){let o=new Map(r.map(l=>[l.name,s(l)])),a=0;for(let l of o.values())for(let c of l??[])a=Math.max(a,Math.abs(c));return{key:i,label:t,unit:e,map:n,size:a,low:n==="signed"?-a:0,high:a,field:l=>o.get(l.name)}}function yE(i,t){if(t.length===1)return i.force[t[0]];let[e,n]=t.map(r=>i.force[r]),s=new Float32Array(e.length);for(let r=0;r<e.length;++r)s[r]=Math.hypot(e[r],n[r]);return s}var Ri=new L,Uf=new L,ti=new L,sa=new L,po=new Pe,ac=class{constructor(t,e,n){this.body=e,this.planar=t.planar,this.half=t.thickness/2,this.amplitudes=qe(t.amplitude),this.count=t.basis.length,this.vertices=t.x0.find(s=>typeof s!="number")?.n??0,this.x0=li(t.x0,this.vertices),this.basis=t.basis.map(s=>li(s,this.vertices)),this.stressBasis=t.stress.map(s=>li(s,this.vertices)),this.stresses=new Float32Array(this.vertices),this.interfaces=t.interfaces,this.far=e.nodes>1?wE(t.interfaces):0,this.anchors=[0,this.far],this.moved=null,this.e=new Float32Array(this.count),this.u=new Float32Array(3*this.vertices),this.sizes=new Float32Array(this.vertices),this.instants=n,this.build(qe(t.triangles),qe(t.sides)),this.value=this.sizes}build(t,e){let n=this.vertices,s=Array.from(t);if(this.planar){for(let a=0;a<t.length;a+=3)s.push(n+t[a],n+t[a+2],n+t[a+1]);for(let a=0;a<e.length;a+=2){let l=e[a],c=e[a+1];s.push(l,n+l,n+c,l,n+c,c)}}let r=new nn,o=this.planar?2*n:n;r.setAttribute("position",new Ke(new Float32Array(3*o),3)),r.setAttribute("color",new Ke(new Float32Array(3*o),3)),r.setIndex(new Ke(new Uint32Array(s),1)),this.mesh=new Le(r,Qn(16777215,!0)),this.mesh.frustumCulled=!1}at(t,e){let n=this.count,s=t*n,r=Math.min(t+1,this.instants-1)*n;for(let o=0;o<n;++o)this.e[o]=(1-e)*this.amplitudes[s+o]+e*this.amplitudes[r+o]}stress(){let{stressBasis:t,e,stresses:n}=this,s=t[0]?.length??0,r=new Float64Array(6),o=0;for(let a=0;s>0&&a<this.vertices;++a){r.fill(0);for(let l=0;l<this.count;++l)for(let c=0;c<s;++c)r[c]+=e[l]*t[l][c][a];n[a]=s===3?bE(r):SE(r),o=Math.max(o,n[a])}return o}deform(t){let{u:e,e:n,basis:s,vertices:r}=this;e.fill(0);for(let o=0;o<this.count;++o)for(let a=0;a<3;++a){let l=s[o][a],c=t*n[o];if(c!==0)for(let h=0;h<r;++h)e[3*h+a]+=c*l[h]}this.findChord()}findChord(){let{body:t,interfaces:e,far:n}=this;this.turn=(this.turn??new Pe).identity(),this.stretch=(this.stretch??new L).set(0,0,0),n&&(po.fromArray(t.q,0).conjugate(),Uf.set(...[0,1,2].map(s=>t.x[3*n+s]-t.x[s])).applyQuaternion(po),Ri.fromArray(e,3*n),this.length2=Ri.lengthSq(),this.c0=(this.c0??new L).copy(Ri),ti.copy(Ri).normalize(),this.turn.setFromUnitVectors(ti,vE.copy(Uf).normalize()),this.stretch.copy(Uf).sub(Ri.applyQuaternion(this.turn)))}shareAt(t,e,n){return this.far?(t*this.c0.x+e*this.c0.y+n*this.c0.z)/this.length2:0}share(t){return this.shareAt(...this.interfaces.slice(3*t,3*t+3))}bend(t,e){let{body:n,interfaces:s}=this;po.fromArray(n.q,0),e.set(...[0,1,2].map(o=>n.x[3*t+o]-n.x[o])).applyQuaternion(ME.copy(po).conjugate()),Ri.fromArray(s,3*t);let r=this.shareAt(Ri.x,Ri.y,Ri.z);return e.sub(Ri.applyQuaternion(this.turn).addScaledVector(this.stretch,r)).applyQuaternion(po)}shift(t,e,n){if(this.moved=null,t.lengthSq()+e.lengthSq()===0&&!n.length)return;let s=po.fromArray(this.body.q,0).conjugate(),r=o=>new L().copy(o).applyQuaternion(s);this.moved={a:r(t),b:r(e),bumps:n.map(({node:o,by:a})=>{let l=new L().fromArray(this.interfaces,3*o),c=1/0;for(let h=0;3*h<this.interfaces.length;++h)h!==o&&(c=Math.min(c,l.distanceToSquared(Ri.fromArray(this.interfaces,3*h))));return{at:l,by:r(a),square:c}})}}along(t,e,n){let{a:s,b:r,bumps:o}=this.moved;sa.copy(s).lerp(r,this.shareAt(t,e,n));for(let{at:a,by:l,square:c}of o){let h=1-((t-a.x)**2+(e-a.y)**2+(n-a.z)**2)/c;h>0&&sa.addScaledVector(l,h*h)}}update(t,e,n){let{x0:s,u:r,vertices:o,half:a,planar:l,body:c,mesh:h}=this,u=h.geometry.attributes.position.array,f=h.geometry.attributes.color.array;h.position.fromArray(c.x,0),h.quaternion.fromArray(c.q,0);let p=t-1;for(let g=0;g<o;++g){let x=s[0][g],m=s[1][g],d=s[2][g],M=3*g;this.sizes[g]=this.deformation(x,m,d,M);let b=x+r[M]+p*ti.x,y=m+r[M+1]+p*ti.y,U=d+r[M+2]+p*ti.z;this.moved&&(this.along(x,m,d),b+=sa.x,y+=sa.y,U+=sa.z),u[M]=b,u[M+1]=y,u[M+2]=l?U+a:U,e?vr(e.map,(this.value[g]-e.low)/(e.high-e.low||1),f,M):n.toArray(f,M)}l&&this.copyFace(u,f),h.geometry.attributes.position.needsUpdate=!0,h.geometry.attributes.color.needsUpdate=!0}deformation(t,e,n,s){let{u:r,turn:o}=this;ti.set(t,e,n);let a=this.far?ti.dot(this.c0)/this.length2:0;return ti.applyQuaternion(o).addScaledVector(this.stretch,a),ti.set(r[s]+t-ti.x,r[s+1]+e-ti.y,r[s+2]+n-ti.z),ti.length()}place(t,e,n){let{x0:s,vertices:r,mesh:o,planar:a,half:l}=this,c=o.geometry.attributes.position.array,[h,u,f]=[t[e],t[e+1],t[e+2]],p=0,g=1/0;for(let x=0;x<r;++x){let m=(s[0][x]-h)**2+(s[1][x]-u)**2+(s[2][x]-f)**2;m<g&&([p,g]=[x,m])}return n.set(h+c[3*p]-s[0][p],u+c[3*p+1]-s[1][p],a?l:f+c[3*p+2]-s[2][p]),n.applyQuaternion(o.quaternion).add(o.position)}copyFace(t,e){let n=3*this.vertices;for(let s=0;s<n;s+=3)t[n+s]=t[s],t[n+s+1]=t[s+1],t[n+s+2]=t[s+2]-2*this.half;e.copyWithin(n,0,n)}},vE=new L,ME=new Pe;function bE([i,t,e]){return Math.sqrt(Math.max(0,i*i-i*t+t*t+3*e*e))}function SE([i,t,e,n,s,r]){return Math.sqrt(Math.max(0,.5*((i-t)**2+(t-e)**2+(e-i)**2)+3*(n*n+s*s+r*r)))}function wE(i){let t=0,e=0;for(let n=1;3*n<i.length;++n){let s=Math.hypot(i[3*n],i[3*n+1],i[3*n+2]);s>e&&([t,e]=[n,s])}return t}var m0=["#7f9bb8","#b8977f","#86ad8c","#a78fb5","#b5a86f","#7fb0b3"],ui=new L,ra=new Pe;function EE(){let i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info"),e=t?i.getParameter(t.UNMASKED_RENDERER_WEBGL):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)}var lc=class{constructor(t,e){this.canvas=t,this.motion=e,this.t=qe(e.t),this.modes=e.abscissa==="frequency",this.shapes=this.modes||e.abscissa==="load_case",this.fromRest=e.abscissa!=="time",this.bodies=e.bodies.map(n=>new Jl(n,this.t.length)),this.byName=new Map(this.bodies.map(n=>[n.name,n])),Object.assign(this,{instant:0,scale:1,phase:1,colour:null,dirty:!0}),this.plain=EE(),this.renderer=new Il({canvas:t,antialias:!this.plain,preserveDrawingBuffer:!0}),this.plays(!1),this.scene=new Ll,this.camera=new Un(32,1,.01,100),this.measure(),this.addBodies(),this.addRanges(),this.controls=new Zl(this.camera,t),this.controls.addEventListener("change",()=>this.dirty=!0),ds(()=>this.retheme()),this.retheme(),this.fit(),new ResizeObserver(()=>this.resize()).observe(t.parentElement),this.resize()}plays(t){let e=Math.min(devicePixelRatio,2);this.renderer.setPixelRatio(this.plain?t?Math.min(e,1):2:e),this.dirty=!0}measure(){this.box=new Ei;for(let s of this.bodies){let r=s.elements.length?[]:this.armsOf(s);for(let o=0;o<s.xs[0].length;o+=Math.max(1,Math.floor(s.xs[0].length/4e3))){this.box.expandByPoint(ui.set(s.xs[0][o],s.xs[1][o],s.xs[2][o])),ra.set(...s.qs.map(a=>a[o])).normalize();for(let a of r)this.box.expandByPoint(ui.copy(a).applyQuaternion(ra).add(new L(...s.xs.map(l=>l[o]))))}}for(let s of this.motion.joints)for(let r of[0,1])s.bodies[r]==="ground"&&s.places.length&&s.type!=="prismatic"&&this.box.expandByPoint(ui.fromArray(s.places,3*r));for(let s of this.motion.meshes)this.addToBox(s);let t=this.box.getSize(new L);this.size=t.length()||1;let e=[t.x,t.y,t.z].map(s=>s<1e-6*this.size),n=e[2]?2:e[1]?1:e[0]?0:-1;this.planar=this.motion.space==="planar"&&n>=0,this.up=new L(...this.planar&&n===2?[0,1,0]:[0,0,1]),this.normal=new L(...[0,1,2].map(s=>this.planar&&s===n?1:0)),this.planar&&n===1&&this.normal.negate()}addToBox(t){let e=this.byName.get(t.name),n=t.x0.find(o=>typeof o!="number")?.n??0,s=li(t.x0,n),r=new L(...e.x0.slice(0,3));ra.fromArray(e.q0,0);for(let o=0;o<n;o+=Math.max(1,Math.floor(n/4e3)))this.box.expandByPoint(ui.set(s[0][o],s[1][o],s[2][o]).applyQuaternion(ra).add(r))}addBodies(){let{motion:t,size:e}=this;this.parts=[];let n=new Map(t.meshes.map(r=>[r.name,r]));for(let[r,o]of this.bodies.entries()){let a;o.elements.length>0?a=new ec(o,e):n.has(o.name)?a=new ac(n.get(o.name),o,this.t.length):a=new ic(o,this.portsOf(o),e),this.parts.push({view:a,body:o,plain:new se(m0[r%m0.length])}),this.scene.add(a.mesh)}this.viewOf=new Map(this.parts.map(r=>[r.body.name,r.view]));let s=t.joints.filter(r=>r.places.length>0);this.closure=new rc(this.parts,s),this.joints=s.map(r=>new sc(r,this.jointRadius(r),this.up));for(let r of this.joints)this.scene.add(r.mesh)}armsOf(t){let e=[];for(let n=0;n<(t.points?.length??0);n+=3)e.push(new L(...t.points.slice(n,n+3)));return[...e,...this.portsOf(t)]}portsOf(t){return this.motion.joints.flatMap(e=>[0,1].filter(n=>e.bodies[n]===t.name&&e.places.length).map(n=>new L(...e.places.slice(3*n,3*n+3))))}jointRadius(t){let e=t.bodies.map((n,s)=>this.viewOf.get(n)?.radiusAt?.(t.nodes[s])??0);return Math.max(.0095*this.size,Math.min(1.12*Math.max(...e),.03*this.size))}addRanges(){let t=0,e=0,n=0,s=this.t.length;this.largest=0;let r=this.shapes?s:this.motion.meshes.length?60:600;for(let l=0;l<s;l+=Math.max(1,Math.floor(s/r))){let c=t;this.moveBodies(l,0,1);for(let{view:h,body:u}of this.parts)h.sizes&&(e=Math.max(e,h.stress())),h.bend?t=Math.max(t,this.sizeOf(h,u,l)):this.fromRest&&(n=Math.max(n,this.sizeOf(h,u,l)));t>c&&(this.largest=l)}this.deformed=t>0?Math.max(t,n):0;let a={key:"displacement",label:this.fromRest?"displacement":"deformation",unit:"m",map:"size",size:t,low:0,high:t};this.quantities=[...t>0?[a]:[],...this.modes?[]:p0(this.bodies,e)]}sizeOf(t,e,n){if(this.fromRest)return oc(t,e,n).reduce((r,o)=>Math.max(r,o),0);let s=0;t.chord?.update();for(let r=0;t.chord&&r<e.nodes;++r)s=Math.max(s,t.chord.size(r));for(let r=0;r<(t.vertices??0);r+=7)s=Math.max(s,t.deformation(t.x0[0][r],t.x0[1][r],t.x0[2][r],3*r));return s}goodScale(){if(!(this.deformed>0))return 1;let t=.06*this.size/this.deformed,e=10**Math.floor(Math.log10(t));return Math.max(1,[5,2,1].map(n=>n*e).find(n=>n<=t*1.001)??e)}moveBodies(t,e,n){for(let{view:s,body:r}of this.parts)r.at(t,e),r.enlarge(n),s.at&&(s.at(t,e),s.deform(n))}set(t){Object.assign(this,t),this.dirty=!0}update(){let t=this.t.length-1,e=Math.min(Math.floor(this.instant),t),n=this.shapes?0:Math.min(this.instant-e,1),s=this.fromRest?1:this.scale,r=this.colour?.key==="displacement";if(this.fromRest&&r)for(let{view:o,body:a}of this.parts)o.bend&&(o.fromRest=f0(o,a,e,n));this.moveBodies(e,n,this.fromRest?this.phase*this.scale:1);for(let{view:o}of this.parts)o.chord?.update();this.closure.update(s-1);for(let{view:o,body:a,plain:l}of this.parts){let c=this.colourOf(o,a,e,n);if(o.chord&&c&&r)for(let h=0;h<a.nodes;++h)o.value[h]=this.fromRest?o.fromRest[h]:o.chord.size(h);o.spread&&c&&this.colour.key!=="stress"&&o.spread(),o.update(s,c,l)}for(let o of this.joints)o.update(this);this.arrows?.update()}colourOf(t,e,n,s){if(!this.colour)return null;if(t.sizes&&(t.value=this.colour.key==="stress"?t.stresses:this.fromRest&&this.colour.key==="displacement"?t.fromRest:t.sizes),t.sizes&&this.colour.key==="stress"&&t.stress(),this.colour.key==="displacement"||t.sizes&&this.colour.key==="stress")return this.colour;let r=this.colour.field(e);return!r||!t.value||!e.elements.length?null:(e.values(r,n,s,this.colour.key==="stress"?t.ends:t.value),this.colour)}place(t,e,n,s,r){r.fromArray(n,s);let o=this.byName.get(t);if(!o)return r;r.applyQuaternion(this.turn(t,e,ra));let a=this.viewOf.get(t);return a.chord?r.add(a.chord.place(e,this.fromRest?1:this.scale,ui)):r.add(ui.fromArray(o.x,3*Math.min(e,o.nodes-1))).add(this.closure.shiftOf(t,e))}turn(t,e,n){let s=this.byName.get(t);return s?n.fromArray(s.q,4*Math.min(e,s.nodes-1)):n.identity()}openings(){return this.update(),Object.fromEntries(this.joints.map(({joint:t})=>[t.name,this.drawn(t,0).distanceTo(this.drawn(t,1))]))}drawn(t,e){let n=t.bodies[e],s=t.nodes[e],r=this.viewOf.get(n),o=new L;return!r||r.chord?this.place(n,s,t.places,3*e,o):r.place?r.place(r.interfaces,3*s,o):o.fromArray(t.places,3*e).applyQuaternion(r.mesh.quaternion).add(r.mesh.position)}draw(){return this.dirty?(this.dirty=!1,this.update(),this.renderer.render(this.scene,this.camera),!0):!1}fit(){let t=this.box.getCenter(new L),e=(this.fromRest?.1:.05)*this.size,s=(this.planar?this.normal.clone().addScaledVector(this.up,.2).addScaledVector(ui.crossVectors(this.up,this.normal),-.1):new L(.75,-1,.55)).normalize(),r=new L().crossVectors(this.up,s).normalize(),o=new L().crossVectors(s,r),a=Math.tan(this.camera.fov/2*Math.PI/180),l=this.camera.aspect||1,c=0;for(let h=0;h<8;++h)ui.set(...[0,1,2].map(u=>(h>>u&1?this.box.max:this.box.min).getComponent(u))).sub(t),c=Math.max(c,(Math.abs(ui.dot(r))+e)/(a*l)+ui.dot(s),(Math.abs(ui.dot(o))+e)/a+ui.dot(s));this.camera.up.copy(this.up),this.camera.position.copy(t).addScaledVector(s,c),this.camera.near=c/100,this.camera.far=c*20,this.camera.updateProjectionMatrix(),this.controls.target.copy(t),this.controls.update(),this.dirty=!0}resize(){let{clientWidth:t,clientHeight:e}=this.canvas.parentElement;if(!t||!e)return;let n=this.camera.aspect;this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),Math.abs(n-this.camera.aspect)>.2&&this.fit(),this.dirty=!0}retheme(){this.scene.background=new se(dn("sky")),this.grid&&this.scene.remove(this.grid.helper);let t=this.planar?this.normal:this.up,e=this.planar?-.04*this.size+this.box.min.dot(t):this.box.min.dot(t)-.03*this.size;this.grid=r0(this.box,t,e,new se(dn("grid"))),this.scene.add(this.grid.helper),this.dirty=!0}};var AE=8,TE=[.1,.25,.5,1,2,4],CE=[1,1e4],RE=[.1,10],cc=class{constructor(t,e,n){Object.assign(this,{motion:t,clock:e,summary:n,cases:n.load_cases,playing:!1,speed:1,phase:0,frames:[]}),this.modes=t.abscissa==="frequency",this.shapes=this.modes||t.abscissa==="load_case",this.larger=this.modes?"amplitude":t.abscissa==="time"?"deformation":"displacement",this.scales=this.modes?RE:CE,this.instantText=t.unit==="s"?ga([e.last],"s"):s=>t.unit==="-"?ze(s,4):zt(s,t.unit,4),this.canvas=N("canvas",{tabindex:0,"aria-label":"mechanism; drag to turn, wheel to zoom"}),this.stage=N("div",{class:"stage"},this.canvas),this.bar=N("div",{class:"colours"}),this.marks=N("div",{class:"legend"}),this.caption=N("p",{class:"printed note"}),this.node=N("section",{class:"card viewer"},this.stage,this.bar,this.marks,this.caption,this.controls()),this.hint()}start(){try{this.view=new lc(this.canvas,this.motion)}catch{this.stage.replaceChildren(N("p",{class:"note"},"No picture in space: this browser has no WebGL here."));return}if(this.canvas.openings=()=>this.view.openings(),this.fillColours(),this.setScale(this.modes?1:this.view.goodScale()),this.summary.fixed_loads&&this.view.parts.some(e=>e.view.sizes)&&(this.fixed=new Yl(this.view,this.summary)),!(this.view.deformed>0))for(let e of[this.scaler,this.node.querySelector("#good")])e.disabled=!0;this.clock.listen(()=>this.show()),this.clock.listen(Oa(()=>this.tell())),this.modes||this.clock.set(this.clock.t[this.motion.opens??this.view.largest]),this.modes&&this.toggle(!0),addEventListener("beforeprint",()=>{this.describe(),this.view.draw()});let t=e=>{this.advance(e),this.view.draw()&&this.count(e),requestAnimationFrame(t)};requestAnimationFrame(t)}controls(){let{clock:t}=this,e=(n,s)=>N("input",{type:"range",id:n,...s});return this.button=N("button",{class:"play",id:"play",title:"play or stop (space)",onclick:()=>this.toggle()},"\u25B6"),this.slider=e("time",{min:0,max:this.shapes?t.t.length-1:1,step:this.shapes?1:"any",value:0,disabled:this.shapes&&t.t.length<2,oninput:()=>this.seek(Number(this.slider.value))}),this.label=N("output",{for:"time",id:"instant"}),this.scaler=e("scale",{min:Math.log10(this.scales[0]),max:Math.log10(this.scales[1]),step:.01,value:0,oninput:()=>this.setScale(Nf(10**Number(this.scaler.value)))}),this.scaleLabel=N("output",{for:"scale"}),this.colours=N("select",{id:"colour",onchange:()=>this.setColour(this.colours.value)}),this.rate=N("select",{id:"speed",title:"speed",onchange:()=>this.speed=Number(this.rate.value)},TE.map(n=>N("option",{value:n,selected:n===1},`\xD7 ${n}`))),N("div",{class:"controls"},this.button,N("label",{for:"time"},this.modes?"mode":this.motion.abscissa.replace("_"," ")),this.slider,this.label,N("span",{}),N("label",{for:"scale"},this.larger),this.scaler,this.scaleLabel,N("span",{}),N("label",{for:"colour"},"colour"),N("span",{class:"small"},this.colours,this.rate,N("button",{id:"good",title:`true shape, or ${this.larger} that can be seen (D)`,onclick:()=>this.goodScale()},this.modes?"as computed":"true / magnified"),N("button",{id:"fit",title:"whole motion (F)",onclick:()=>this.view?.fit()},"fit")))}hint(){let{records:t,t:e}=this.motion,n=e.n;if(this.shapes)return;let s=n<t?`${n} of ${t} recorded instants, evenly spread; charts keep every peak`:`${t} instants`;this.node.append(N("p",{class:"hint"},s," \xB7 space plays, \u2190 \u2192 steps, + \u2212 ",this.larger,", C colour, F fits; on a chart P goes to its peak"))}fillColours(){this.colours.append(N("option",{value:""},"bodies"));for(let e of this.view.quantities)this.colours.append(N("option",{value:e.key},e.label));let t=this.view.quantities.find(e=>e.key==="stress")??this.view.quantities[0];this.setColour(t?.key??"")}setColour(t){let e=this.view.quantities.find(r=>r.key===t)??null;if(this.colours.value=t,this.view.set({colour:e}),this.bar.replaceChildren(),!e)return;let n=[0,.25,.5,.75,1].map(r=>va(e.map,r)).join(","),s=N("span",{class:"strip"});s.style.background=`linear-gradient(to right, ${n})`,this.bar.append(N("span",{},e.label),N("span",{},zt(e.low,e.unit,3)),s,N("span",{},zt(e.high,e.unit,3)))}nextColour(){let t=[...this.colours.options].map(e=>e.value);this.setColour(t[(t.indexOf(this.colours.value)+1)%t.length])}setScale(t){this.scale=Math.max(this.scales[0],Math.min(this.scales[1],t)),this.scaler.value=Math.log10(this.scale),this.scaleLabel.textContent=`\xD7 ${ze(this.scale,3)}`,this.view?.set({scale:this.scale})}goodScale(){this.setScale(this.modes||this.scale>1?1:this.view.goodScale())}seek(t){let{clock:e}=this;if(this.shapes)return e.set(e.t[t]);e.set(e.first+t*(e.last-e.first))}show(){let{clock:t}=this,e=Math.round(t.record());this.view.set({instant:this.shapes?e:t.record()});let n=(t.at-t.first)/(t.last-t.first||1);this.slider.value=this.shapes?e:n}tell(){let{clock:t}=this,e=Math.round(t.record());this.fixed&&this.marks.replaceChildren(...this.fixed.legend()),this.label.textContent=this.cases?.[e]??(this.modes?`${e+1}: `:"")+this.instantText(t.at)}describe(){let t=this.modes?"mode of":this.motion.abscissa.replace("_"," ");this.caption.textContent=`${t} ${this.label.textContent} \xB7 ${this.larger} ${this.scaleLabel.textContent}`}toggle(t=!this.playing){this.playing=t,this.view?.plays(t),this.before=null,this.frames=[],this.button.textContent=t?"\u275A\u275A":"\u25B6",t&&!this.shapes&&this.clock.at>=this.clock.last&&this.clock.set(this.clock.first),!t&&this.shapes&&!this.modes&&this.view.set({phase:1}),t||this.clock.set(this.clock.at)}advance(t){if(!this.playing)return;let e=this.before===null?0:Math.min(t-this.before,200)/1e3;if(this.before=t,this.modes)return this.phase+=2*Math.PI*.5*e*this.speed,this.view.set({phase:Math.sin(this.phase)});if(this.shapes)return this.phase+=2*Math.PI*.4*e*this.speed,this.view.set({phase:.5*(1-Math.cos(this.phase))});let{clock:n}=this,s=n.last-n.first,r=n.at+s/AE*e*this.speed;r>n.last&&(r=n.first),n.set(r,!0)}count(t){this.frames.push(t),this.frames.length>60&&this.frames.shift(),this.frames.length>10&&(this.canvas.dataset.fps=(1e3*(this.frames.length-1)/(t-this.frames[0])).toFixed(1)),this.canvas.dataset.drawn=Number(this.canvas.dataset.drawn??0)+1}key(t){let e={" ":()=>this.toggle(),ArrowLeft:()=>this.clock.step(-1),ArrowRight:()=>this.clock.step(1),"+":()=>this.setScale(Nf(this.scale*1.5)),"-":()=>this.setScale(Nf(this.scale/1.5)),f:()=>this.view.fit(),c:()=>this.nextColour(),d:()=>this.goodScale()}[t.key.length===1?t.key.toLowerCase():t.key];return!e||!this.view?!1:(e(),!0)}};function Nf(i){let t=10**(Math.floor(Math.log10(i))-1);return Math.round(i/t)*t}var PE=120,IE=760;function LE(){let i=Jp(),t=i.summary;document.title=`${Tc(i)} \u2013 liesl ${t.command??""}`;let e=i.motion?new gs(qe(i.motion.t)):null,n=i.motion?new cc(i.motion,e,t):null,s=N("div",{class:"column"}),r=N("div",{class:"column"}),o=N("div",{class:"columns"},s,r),a=N("main",{},o);document.body.append(NE(),dd(i),a,N("footer",{},`liesl ${t.versions?.liesl??""} \xB7 ${t.command??""}`));let l=(p,...g)=>p.append(...g.filter(Boolean));n&&l(s,n.node),n?.start();let c=n&&!n.shapes?e:null;c&&l(r,...hh(i.charts,c));let h=[...hd(t),_d(t),Vg(i),kg(i,n),...i.cases?sm(i):[]],u=pd(i),f=p=>{let g=p===s?r:s;return g0()&&g.offsetHeight<p.offsetHeight-PE?g:p};if(!n)for(let p of hh(i.charts,null))l(s.offsetHeight>r.offsetHeight?r:s,p);for(let p of[u,md(t)])l(f(s),p);for(let p of[i.motion?.abscissa==="frequency"||!u?gd(t,i.charts[0]):null,xd(t),yd(t,n?.modes?e:null)])l(f(r),p);l(a,...h,vd(i));for(let p of[s,r])p.childNodes.length||p.remove();o.childNodes.length||o.remove(),n?.node.classList.toggle("alone",s.childNodes.length===1),a.classList.toggle("single",!(s.isConnected&&r.isConnected));for(let p of[s,r])DE(p);n&&s.isConnected&&r.isConnected&&UE(n.stage,s,r),addEventListener("keydown",p=>{let g=p.target.matches?.("input:not([type=range]), select, textarea"),x=p.target.matches?.("input[type=range]")&&p.key.startsWith("Arrow"),m=p.target.matches?.("button, a, th")&&(p.key===" "||p.key==="Enter");g||x||m||p.ctrlKey||p.metaKey||p.altKey||n?.key(p)&&p.preventDefault()}),requestAnimationFrame(()=>document.documentElement.dataset.ready=Math.round(performance.now()))}function g0(){return matchMedia("(min-width: 981px)").matches}function DE(i){let t=()=>i.style.top=`${Math.min(14,innerHeight-i.offsetHeight-14)}px`;new ResizeObserver(t).observe(i),addEventListener("resize",t)}function UE(i,t,e){let n=()=>{i.style.height="";let s=Math.min(e.offsetHeight,innerHeight-28)-t.offsetHeight;g0()&&s>0&&(i.style.height=`${Math.min(i.offsetHeight+s,Math.max(i.offsetHeight,IE))}px`)};new ResizeObserver(n).observe(e),addEventListener("resize",n)}function NE(){return N("button",{id:"theme",title:"light or dark","aria-label":"light or dark",onclick:()=>bc(!pa())},"\u25D0")}LE();})();
